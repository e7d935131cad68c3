# Writes OUTPUT, a source file with the hash of all sources below ROOT that the program and the library are made of, and
# of FLAGS, by which they are compiled.
# usage: cmake -DROOT=… -DFLAGS=… -DOUTPUT=… -P build_id.cmake
file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/src/*.?pp ${ROOT}/formats/*.?pp ${ROOT}/include/*.hpp)
list(APPEND sources CMakeLists.txt src/CMakeLists.txt src/app/CMakeLists.txt formats/CMakeLists.txt)
list(SORT sources)
set(all "${FLAGS}")
foreach(source IN LISTS sources)
  file(SHA1 ${ROOT}/${source} hash)
  string(APPEND all "\n${source} ${hash}")
endforeach()
string(SHA1 id "${all}")
file(WRITE ${OUTPUT} "// Made by cmake/build_id.cmake.
namespace keyblock {
extern const char* const kBuildHash;
const char* const kBuildHash = \"${id}\";
}  // namespace keyblock
")
