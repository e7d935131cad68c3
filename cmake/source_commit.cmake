# Writes OUTPUT, a source file with the commit of the sources below ROOT, and a + if sources of the program differ from
# it: changed, added or deleted ones. An unchanged text is not written again, so that nothing is linked anew.
# usage: cmake -DROOT=… -DGIT=… -DOUTPUT=… -P source_commit.cmake
set(commit "")
if(GIT AND EXISTS ${ROOT}/.git)
  execute_process(COMMAND ${GIT} describe --always --abbrev=7 --exclude=* WORKING_DIRECTORY ${ROOT}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(
    COMMAND ${GIT} --no-optional-locks status --porcelain --untracked-files=all -- CMakeLists.txt
      src/*.?pp src/*CMakeLists.txt formats/*.?pp formats/CMakeLists.txt include/*.hpp page/built/*.html
      page/src/draw/palette.json
    WORKING_DIRECTORY ${ROOT} OUTPUT_VARIABLE differences ERROR_QUIET RESULT_VARIABLE fault)
  if(commit AND (differences OR fault))
    string(APPEND commit "+")
  endif()
endif()
set(text "// Made by cmake/source_commit.cmake.
namespace keyblock {
extern const char* const kSourceCommit;
const char* const kSourceCommit = \"${commit}\";
}  // namespace keyblock
")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT "${before}" STREQUAL "${text}")
  file(WRITE ${OUTPUT} "${text}")
endif()
