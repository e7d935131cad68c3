"""Checks the Markdown pages of the repository: links, anchors, tables, sentences, words; equations and citations of the
theory, files that the developer's guide names.

Used by make_reference.py --check; `python3 docs/check_pages.py [PAGE…]` checks all pages, or some, without the program,
and those of NOT_YET in full if they are named.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import statistics
import sys
from pathlib import Path

LONGEST_SENTENCE = 35  # words
LONGEST_MEDIAN = 18  # words of the median sentence of a page
WIDEST_CELL = 120  # characters
# plain-english.md: words without meaning, or that readers misread.
NEVER = [r"whatever", r"whoever", r"whereto", r"likewise", r"thereof", r"but for", r"for want of", r"in the mean", r"of today",
         r"(?<!there )is none", r"is no number", r"as of that", r"the one\b[^.;]*\bthe other", r"breaks off", r"passed over",
         r"looks whether", r"in the way of", r"in place of", r"hurts?", r"odd"]
# Pages whose tables, sentences and words are not clean yet; their links are checked all the same. To be emptied.
NOT_YET = []


def pages(root):
    for folder, folders, files in os.walk(root):
        here = Path(folder)
        folders[:] = sorted(f for f in folders if not f.startswith((".", "build")) and f not in ("out", "shared", "__pycache__", "node_modules")
                            and not (here / f / "CMakeCache.txt").exists())
        for name in sorted(files):
            if name.endswith(".md"):
                yield here / name


def without_code(text):
    """The page with code blocks and comments emptied, line by line as it was."""
    def emptied(match):
        return "\n" * match.group(0).count("\n")
    text = re.sub(r"<!--.*?-->", emptied, text, flags=re.S)
    text = re.sub(r"^( *)(```+|~~~+).*?^ *\2 *$", emptied, text, flags=re.S | re.M)
    lines = text.split("\n")
    inside, offset = False, 0  # of the text of the list item
    for i, line in enumerate(lines):
        begins = re.match(r"(\s*(?:[-*+]|\d+[.)])\s+)\S", line)
        if begins and len(line) - len(line.lstrip()) >= offset + 4:
            begins = None
        if begins:
            offset = len(begins.group(1))
        elif line and not line.startswith(" "):
            offset = 0
        deep = bool(line.strip()) and len(line) - len(line.lstrip()) >= offset + 4 and not begins
        if deep and (inside or i == 0 or not lines[i - 1].strip()):
            inside = True
            lines[i] = ""
        elif line.strip():
            inside = False
    return "\n".join(lines)


def anchor_of(heading):
    """The anchor that forges give a heading."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip())
    text = re.sub(r"<[^>]+>", "", text).replace("`", "").replace("*", "")
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def anchors_of(path, known={}):
    if path not in known:
        text = without_code(path.read_text(encoding="utf-8"))
        seen, anchors = {}, set(re.findall(r'<a (?:id|name)="([^"]+)"', text))
        for heading in re.findall(r"^#{1,6} +(.*?) *#*$", text, re.M):
            anchor = anchor_of(heading)
            count = seen.get(anchor, 0)
            seen[anchor] = count + 1
            anchors.add(anchor if count == 0 else f"{anchor}-{count}")
        known[path] = anchors
    return known[path]


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def link_faults(path, text):
    bare = re.sub(r"`[^`\n]*`", lambda m: " " * len(m.group(0)), text)
    targets = [(m.start(), m.group(1)) for m in re.finditer(r"\]\(<?([^()\s>]+(?:\([^()\s]*\))?)>?(?: +\"[^\"]*\")?\)", bare)]
    targets += [(m.start(), m.group(1)) for m in re.finditer(r"^\[[^\]]+\]: +(\S+)", bare, re.M)]
    targets += [(m.start(), m.group(1)) for m in re.finditer(r"<(?:img|a)\b[^>]*?\b(?:src|href)=\"([^\"]+)\"", bare)]
    for position, target in sorted(targets):
        if re.match(r"[a-z][a-z0-9+.-]*:", target):
            continue
        file, _, anchor = target.partition("#")
        to = (path.parent / file).resolve() if file else path
        if not to.exists():
            yield line_of(text, position), f"the link {target} leads to no file"
        elif anchor and to.suffix == ".md" and anchor not in anchors_of(to):
            yield line_of(text, position), f"the link {target} leads to no heading"


def cells_of(row):
    return [c.strip() for c in re.split(r"(?<!\\)\|", row.strip().strip("|"))]


def shown(text):
    """The text as a reader sees it: the words of links, code as one word, no marks."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"<[^>\n]+>", "", text)
    return text


def blocks_of(text):
    """(line, text) of every paragraph and list item; tables, headings, mathematics and code are left out."""
    text = re.sub(r"\$\$.*?\$\$", lambda m: "\n" * m.group(0).count("\n"), text, flags=re.S)
    first, block = 0, []
    for number, line in enumerate(text.split("\n") + [""], 1):
        bare = line.strip()
        begins = re.match(r"([-*+]|\d+[.)])\s+", bare)
        if not bare or begins or bare.startswith(("#", "|")):
            if block:
                yield first, " ".join(block)
            block = []
        if bare and not bare.startswith(("#", "|")) and not re.match(r"\[[^\]]+\]: \S+$", bare):
            bare = re.sub(r"^>\s?", "", bare[begins.end():] if begins else bare)
            if not block:
                first = number
            block.append(bare)


def sentences_of(block):
    """The words of each sentence of a paragraph; code and formulas are one word each."""
    block = re.sub(r"`[^`]*`|\$[^$]+\$", "code", shown(block))
    for piece in re.split(r"(?<=[.!?])[)\"”’*_]*\s+(?=[\"“(*_]*[A-ZÀ-Ý0-9]|code|…)|(?<=:)\s*$", block):
        yield re.findall(r"[^\s–—]*\w[^\s]*", piece)


def sentence_lengths(block):
    return [len(words) for words in sentences_of(block) if words]


def long_sentences(block):
    """(number of words, first words) of each sentence that is too long."""
    return [(len(words), " ".join(words[:6])) for words in sentences_of(block) if len(words) > LONGEST_SENTENCE]


def style_faults(text):
    lengths = [n for _, block in blocks_of(text) for n in sentence_lengths(block)]
    if lengths and statistics.median(lengths) > LONGEST_MEDIAN:
        yield 1, f"the median sentence has {statistics.median(lengths):g} words, more than {LONGEST_MEDIAN}"
    for number, line in enumerate(text.split("\n"), 1):
        if line.lstrip().startswith("|"):
            for cell in cells_of(line):
                if len(shown(cell)) > WIDEST_CELL:
                    yield number, f"a table cell has {len(shown(cell))} characters, more than {WIDEST_CELL}"
    for number, block in blocks_of(text):
        for words, beginning in long_sentences(block):
            yield number, f"a sentence has {words} words, more than {LONGEST_SENTENCE}: {beginning} …"
    bare = re.sub(r"`[^`\n]*`", "", text)
    for pattern in NEVER:
        for found in re.finditer(rf"\b{pattern}\b", bare, re.I):
            yield line_of(bare, found.start()), f"the word \"{found.group(0)[:40]}\" is one of the never-list"


def theory_faults(root, text):
    tags = {m.group(1): line_of(text, m.start()) for m in re.finditer(r"\\tag\{(\d+\.\d+[a-z]?)\}", text)}
    heading = re.search(r"^## Implementation *$", text, re.M)
    if not heading:
        if tags:
            yield 1, "the chapter has no section \"## Implementation\""
        return
    end = re.search(r"^## ", text[heading.end():], re.M)
    section = text[heading.end():heading.end() + end.start() if end else len(text)]
    seen = set()
    for m in re.finditer(r"^\|(.*)\|\s*$", section, re.M):
        cells = [c.strip().strip("`").strip() for c in cells_of(m.group(0))]
        numbers = re.findall(r"\d+\.\d+[a-z]?", cells[0])
        if len(cells) != 3 or not numbers:
            continue
        number = line_of(text, heading.end() + m.start())
        span = re.fullmatch(r"\(?(\d+)\.(\d+)\)?\s*[–-]\s*\(?\1\.(\d+)\)?", cells[0])
        seen.update(f"{span[1]}.{n}" for n in range(int(span[2]), int(span[3]) + 1)) if span else seen.update(numbers)
        files = re.split(r"`?\s*,\s*`?", cells[1])
        missing = [f for f in files if not (root / f).is_file()]
        for file in missing:
            yield number, f"there is no file {file}"
        source = "\n".join((root / f).read_text(encoding="utf-8") for f in files if f not in missing)
        for name in re.split(r"`?\s*,\s*`?", cells[2]) if not missing else []:
            if name.rstrip("()").split("::")[-1] not in source:
                yield number, f"{cells[1]} has no {name}"
    for tag, number in tags.items():
        if tag not in seen:
            yield number, f"the equation ({tag}) has no row under \"## Implementation\""
    for tag in sorted(seen - set(tags)):
        yield 1, f"a row under \"## Implementation\" names ({tag}), which no equation has"


# "Burman 2010", "Simo and Tarnow (1992)", "Liu et al. 2009", "Doolin and Sitar 2001, 2002"
NAME = r"(?:de Souza Neto|[A-ZÀ-ÝŠŽ][\w’\-–]+)"
CITATION = re.compile(rf"\b({NAME}(?:,? et al\.|(?:, {NAME})*(?:,? (?:and|&) {NAME})?)) \(?((?:1[6-9]|20)\d\d(?:, (?:1[6-9]|20)\d\d)*)\b")


def works_of(root):
    """Returns the bibliography: (surname of the first author, year) → surnames of the heading."""
    works = {}
    for heading in re.findall(r"^### +(.*?) *$", (root / "docs/theory/references.md").read_text(encoding="utf-8"), re.M):
        names, _, year = heading.rpartition(" ")
        surnames = re.split(r", | and ", names.replace(" et al.", ""))
        works[surnames[0], year] = surnames
    return works


def citation_faults(text, works, cited):
    """Citations without an entry in the bibliography, in theory, reference, formats and cases."""
    text = re.sub(r"^\[[^\]]+\]: .*$", "", text, flags=re.M)  # definitions of links
    text = re.sub(r"\$\$.*?\$\$|\$[^$\n]+\$|`[^`\n]*`", lambda m: "\n" * m.group(0).count("\n") or "code", text, flags=re.S)
    text = re.sub(r"\[([^\[\]]*)\](?:\([^()]*\)|\[[^\[\]]*\])?", r"\1", text)  # the words of links
    for found in CITATION.finditer(re.sub(r"(?<=\S)\n(?=\S)", " ", text)):  # a line may end within a name
        surnames = re.split(r", | and | & ", re.sub(r",? et al\.", "", found[1]))
        for year in found[2].split(", "):
            known = works.get((surnames[0], year))
            cited.add((surnames[0], year))
            if known is None or ("et al." not in found[1] and surnames != known):
                yield line_of(text, found.start()), f"the citation \"{found[1]} {year}\" has no entry in docs/theory/references.md"


def dev_faults(root, text):
    """Files that the developer's guide names and that are not there."""
    for found in re.finditer(r"`((?:src|formats|tests|docs|legacy_cases|include|python|examples)/[\w./-]+)`", text):
        name = found[1]
        if not (root / name).exists() and not re.search(r"/(?:NAME|CASE)", name):
            yield line_of(text, found.start()), f"there is no file {name}"


def faults_of(root, only=None):
    faults = []
    works, cited = works_of(root), set()
    for path in only or pages(root):
        name = path.resolve().relative_to(root).as_posix()
        whole = path.read_text(encoding="utf-8")
        text = without_code(whole)
        found = list(link_faults(path.resolve(), text))
        style = list(style_faults(text))
        if only or name not in NOT_YET:
            found += style
        elif not style:
            print(f"{name} is clean: take it off the list NOT_YET of docs/check_pages.py", file=sys.stderr)
        if name.startswith("docs/theory/"):
            found += theory_faults(root, whole)
        if name.startswith("docs/dev/"):
            found += dev_faults(root, whole)
        if name.startswith(("docs/theory/", "docs/reference/", "formats/", "legacy_cases/")) and name != "docs/theory/references.md":
            found += citation_faults(text, works, cited)
        faults += [f"{name}:{number}: {fault}" for number, fault in sorted(found)]
    if not only:
        faults += [f"docs/check_pages.py: NOT_YET names {name}, which is not there" for name in NOT_YET
                   if not (root / name).is_file()]
        faults += [f"docs/theory/references.md: no page cites {name} {year}" for name, year in works if (name, year) not in cited]
    return faults


if __name__ == "__main__":
    found = faults_of(Path(__file__).resolve().parent.parent, [Path(a) for a in sys.argv[1:]] or None)
    for fault in found:
        print(fault)
    sys.exit(1 if found else 0)
