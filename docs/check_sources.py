"""Checks the words of the sources: comments and messages in C++, comments and docstrings in Python.

No comment or message has a word of the never-list. No sentence of a comment has more than 35 words. The first comment
of a header begins with a verb. Subjects of the newest commits have at most 72 characters. make_reference.py --check
runs it; `python3 docs/check_sources.py` prints the faults.
With --count it prints figures: first comments without a verb, comments that begin with "Of", median sentences, cells.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import ast
import io
import re
import statistics
import subprocess
import sys
import tokenize
from pathlib import Path

import check_pages

LONGEST_SUBJECT = 72

FOLDERS = ("src", "formats", "include", "tests", "examples", "python")
PYTHON_FOLDERS = ("tests", "examples", "python", "docs")
LISTS_OF_WORDS = ("tests/base/diagnostics_test.cpp", "docs/check_pages.py")  # hold the never-list themselves
TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|R"([^()\s\\]{0,16})\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'""", re.S)
VERB = re.compile(r"[A-Z][a-z]+s\b(?<!This)")  # "Computes", as the first word of a header
BARE_OPENING = re.compile(r"(?:Of|As|By)\b")


def sources(root):
    for folder in FOLDERS:
        for ending in ("*.hpp", "*.cpp"):
            yield from sorted((root / folder).rglob(ending))


def python_sources(root):
    for folder in PYTHON_FOLDERS:
        yield from sorted(p for p in (root / folder).rglob("*.py") if "build" not in p.parts)


def python_texts(text):
    """(line, text) of every docstring and comment; comments on lines that follow one another are one."""
    found = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
            found.append((node.body[0].lineno, ast.get_docstring(node)))
    last = [-1, "", False]  # line, text, on a line of its own
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type != tokenize.COMMENT:
            continue
        alone = not token.line[:token.start[1]].strip()
        body = token.string.lstrip("#")[1:]
        if alone and last[2] and token.start[0] == last[0] + last[1].count("\n") + 1:
            last[1] += "\n" + body
        else:
            last = [token.start[0], body, alone]
            found.append(last)
    return [(line, body) for line, body, *_ in found]


def tokens(text):
    """(start, end, text) of comments and literals; digit separators are no quotes."""
    text = re.sub(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])", "_", text)
    return [(m.start(), m.end(), m.group(0)) for m in TOKEN.finditer(text)]


def comments(text):
    """(line, text) of every comment; lines of `//` that follow one another are one comment."""
    found, end = [], -1
    for start, stop, token in tokens(text):
        if not token.startswith("/"):
            continue
        begins_line = not text[text.rfind("\n", 0, start) + 1:start].strip()
        body = re.sub(r"^///?<? ?", "", token) if token.startswith("//") else token[2:-2]
        if found and begins_line and found[-1][2] and text[end:start].strip() == "" and text[end:start].count("\n") == 1:
            found[-1][1] += "\n" + body
        else:
            found.append([check_pages.line_of(text, start), body, begins_line])
        end = stop
    return [(line, body) for line, body, _ in found]


def messages(text):
    """(line, text) of literals with blanks; adjacent literals are one, raw ones are left out."""
    found, end = [], -1
    for start, stop, token in tokens(text):
        if not token.startswith('"'):
            continue
        if found and not text[end:start].strip():
            found[-1][1] += token[1:-1]
        else:
            found.append([check_pages.line_of(text, start), token[1:-1]])
        end = stop
    return [(line, body) for line, body in found if re.search(r"[a-z] [a-z]", body)]


def paragraphs(comment):
    """The prose of a comment: indented lines are formulas, lines of a list are paragraphs of their own."""
    block = []
    for line in comment.split("\n") + [""]:
        if not line.strip() or line.startswith("  ") or re.match(r"([-*@|]|\d+[.)] )", line.strip()):
            if block:
                yield " ".join(block)
            block = [re.sub(r"^([-*]|\d+[.)])\s+", "", line.strip())] if line.strip() and not line.startswith("  ") else []
        elif not line.startswith("SPDX"):
            block.append(line.strip())


def long_sentences(comment):
    # A sentence may begin with a name or a number, in lower case.
    for piece in (p for block in paragraphs(comment) for p in re.split(r"(?<=\.)\s+", block)):
        for words, beginning in check_pages.long_sentences(piece):
            yield f"a sentence has {words} words, more than {check_pages.LONGEST_SENTENCE}: {beginning} …"


def excluded_words(text):
    bare = " ".join(re.sub(r"`[^`]*`|even-odd", " ", text).split())
    for pattern in check_pages.NEVER:
        for match in re.finditer(rf"\b{pattern}\b", bare, re.I):
            yield f"the word \"{match.group(0)[:40]}\" is one of the never-list"


def long_subjects(root):
    """Yields a fault for each long subject of the newest commits; none outside a repository."""
    try:
        log = subprocess.run(["git", "log", "--first-parent", "-20", "--format=%h %s"], cwd=root, capture_output=True,
                             text=True, check=False).stdout
    except OSError:
        return
    for name, _, subject in (line.partition(" ") for line in log.splitlines()):
        if len(subject) > LONGEST_SUBJECT:
            yield f"commit {name}: the subject has {len(subject)} characters, at most {LONGEST_SUBJECT}"


def faults_of(root):
    faults = list(long_subjects(root))
    for path in python_sources(root):
        name = path.relative_to(root).as_posix()
        for line, body in python_texts(path.read_text(encoding="utf-8")) if name not in LISTS_OF_WORDS else []:
            faults += [f"{name}:{line}: {fault}" for fault in [*excluded_words(body), *long_sentences(body)]]
    for path in sources(root):
        if path.relative_to(root).as_posix() in LISTS_OF_WORDS:
            continue
        text = path.read_text(encoding="utf-8")
        if path.suffix == ".hpp" and not VERB.match(first_sentence(text)):
            faults.append(f"{path.relative_to(root).as_posix()}:1: the first comment does not begin with a verb")
        for line, comment in comments(text):
            found = list(excluded_words(comment)) + list(long_sentences(comment))
            faults += [f"{path.relative_to(root).as_posix()}:{line}: {fault}" for fault in found]
        for line, message in messages(text):
            faults += [f"{path.relative_to(root).as_posix()}:{line}: {fault}" for fault in excluded_words(message)]
    return faults


def first_sentence(text):
    found = comments(text)
    return re.split(r"(?<=[.:])\s", " ".join(found[0][1].split()))[0] if found else ""


def print_counts(root):
    headers = [p for p in sources(root) if p.suffix == ".hpp"]
    first = {p: first_sentence(p.read_text(encoding="utf-8")) for p in headers}
    bare = [p for p, sentence in first.items() if not VERB.match(sentence)]
    asking = [p for p, sentence in first.items() if re.match(r"(What|How|Whether|Where|Which)\b", sentence)]
    openings = {}
    for path in sources(root):
        for _, comment in comments(path.read_text(encoding="utf-8")):
            word = BARE_OPENING.match(comment)
            if word:
                openings[word.group(0)] = openings.get(word.group(0), 0) + 1
    print(f"headers that do not begin with a verb: {len(bare)} of {len(headers)}")
    for path in bare:
        print(f"  {path.relative_to(root)}: {first[path]}")
    print(f"headers that begin with What, How, Whether, Where, Which: {len(asking)}")
    print("comments that begin with Of, As, By: " + ", ".join(f"{word} {count}" for word, count in sorted(openings.items())))
    longest, medians = (0, ""), []
    for path in check_pages.pages(root):
        text = check_pages.without_code(path.read_text(encoding="utf-8"))
        lengths = [n for _, block in check_pages.blocks_of(text) for n in check_pages.sentence_lengths(block)]
        cells = [len(check_pages.shown(c)) for line in text.split("\n") if line.lstrip().startswith("|")
                 for c in check_pages.cells_of(line)]
        name = path.relative_to(root).as_posix()
        longest = max(longest, (max(cells, default=0), name))
        if len(lengths) > 5:
            medians.append((statistics.median(lengths), name))
    medians.sort(reverse=True)
    print("words of the median sentence, the highest pages: " + "; ".join(f"{n} {m:g}" for m, n in medians[:5]))
    print(f"words of the median sentence, median of {len(medians)} pages: {statistics.median(m for m, _ in medians):g}")
    print(f"longest cell: {longest[0]} characters ({longest[1]})")


if __name__ == "__main__":
    ROOT = Path(__file__).resolve().parent.parent
    if sys.argv[1:] == ["--count"]:
        print_counts(ROOT)
        sys.exit(0)
    FAULTS = faults_of(ROOT)
    for fault in FAULTS:
        print(fault)
    sys.exit(1 if FAULTS else 0)
