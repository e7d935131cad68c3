#!/usr/bin/env python3
"""Writes the benchmark board: one HTML file with all verification cases, that loads nothing and works from disk.

usage: docs/make_board.py FILE

Values are those of docs/verification/results.json, which `make verification` writes. Costs and extremes are the tables of
legacy_cases/fronts, docs/random_scenes.md and docs/dev/performance.md.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import html
import re
import sys
from pathlib import Path
from urllib.parse import quote

import make_verification as manual

ROOT = manual.ROOT
FRONTS = ROOT / "legacy_cases" / "fronts"
ROWS_SHOWN = 6

STYLE = """
:root { --ground: #f6f5f1; --card: #fff; --ink: #1d2126; --soft: #5c646d; --line: #dcd9d0; --mark: #0b6e6e; --marked: #e3f0ee;
  --miss: #a8321f; --listed: #8a5a00; color-scheme: light dark; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #15181b; --card: #1e2226; --ink: #e4e6e8; --soft: #9aa3ab; --line: #343a40; --mark: #6cc7c0; --marked: #1d3535;
    --miss: #f08a76; --listed: #e0b25c; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--ink); font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; }
header, main { max-width: 1240px; margin: 0 auto; padding: 0 20px; }
header { padding-top: 28px; }
h1 { font-size: 26px; line-height: 1.2; margin: 0 0 6px; text-wrap: balance; }
h2 { font-size: 20px; margin: 40px 0 10px; }
h3 { font-size: 17px; margin: 0; }
h4 { font-size: 15px; margin: 20px 0 6px; }
p { margin: 6px 0; max-width: 76ch; }
.soft { color: var(--soft); }
nav { position: sticky; top: 0; z-index: 1; background: var(--ground); border-bottom: 1px solid var(--line); }
nav > div { max-width: 1240px; margin: 0 auto; padding: 8px 20px; display: flex; flex-wrap: wrap; gap: 8px 12px; align-items: center; }
nav label { color: var(--soft); display: flex; gap: 6px; align-items: center; max-width: 100%; }
select, input { font: inherit; color: var(--ink); background: var(--card); border: 1px solid var(--line); border-radius: 6px; padding: 4px 8px;
  min-width: 0; max-width: 100%; }
:focus-visible { outline: 2px solid var(--mark); outline-offset: 1px; }
article { background: var(--card); border: 1px solid var(--line); border-radius: 10px; margin: 14px 0; padding: 16px; display: grid;
  grid-template-columns: 300px minmax(0, 1fr); gap: 4px 20px; }
article > details { grid-column: 1 / -1; }
.picture img, figure img { width: 100%; background: #fff; border-radius: 6px; display: block; }
@media screen and (prefers-color-scheme: dark) { .picture img, figure img { filter: invert(.91) hue-rotate(180deg); } }
.picture img { max-height: 380px; object-fit: contain; object-position: top; }
dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 1px 12px; margin: 8px 0; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
.wide { overflow-x: auto; max-width: 100%; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 3px 12px 3px 0; border-bottom: 1px solid var(--line); vertical-align: top; }
article th, article td { font-size: 13px; padding-right: 8px; }
article td.n { white-space: nowrap; }
a { color: var(--mark); }
th { font-weight: 600; color: var(--soft); }
td.n { text-align: right; padding-left: 8px; }
th.n { text-align: right; }
td.ours { background: var(--marked); padding-left: 10px; }
main > .wide { margin: 0 0 12px; } main > .wide .many { min-width: min(720px, 200vw); }
code { font: 13px/1.4 ui-monospace, "DejaVu Sans Mono", monospace; }
pre { margin: 8px 0 0; padding: 6px 10px; border: 1px solid var(--line); border-radius: 6px; white-space: pre-wrap; overflow-wrap: anywhere; }
summary { cursor: pointer; color: var(--mark); padding: 4px 0; }
.miss { color: var(--miss); font-weight: 600; } .listed { color: var(--listed); } .tag { color: var(--mark); }
figure { margin: 0; } .figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(380px, 100%), 1fr)); gap: 16px; margin: 12px 0; }
figcaption { color: var(--soft); font-size: 13px; padding-top: 4px; }
[data-profile="standard"] .legacy, [data-profile="legacy"] .standard, [hidden] { display: none; }
@media (max-width: 760px) {
  header, main, nav > div { padding-left: 12px; padding-right: 12px; }
  nav { position: static; }
  article { grid-template-columns: minmax(0, 1fr); padding: 12px; } }
"""

SCRIPT = """
const topic = document.getElementById("topic"), profile = document.getElementById("profile"), words = document.getElementById("words");
function choose() {
  document.body.dataset.profile = profile.value;
  let shown = 0;
  for (const card of document.querySelectorAll("article")) {
    const fits = (!topic.value || card.dataset.topic === topic.value) && (!profile.value || card.dataset.profiles.includes(profile.value)) &&
      card.dataset.words.includes(words.value.trim().toLowerCase());
    card.hidden = !fits;
    shown += fits;
  }
  document.getElementById("shown").textContent = shown + (shown === 1 ? " case" : " cases");
}
for (const input of [topic, profile, words]) input.addEventListener("input", choose);
choose();
"""


def picture(path):
    """An SVG file as the address of an image: no file is loaded."""
    return "data:image/svg+xml," + quote(path.read_text(encoding="utf-8"), safe=" ,/:;=()<>!?@[]{}|+*$'~-._")


def inline(text):
    """HTML of a line of Markdown: code, bold, the words of links."""
    parts = re.split(r"`([^`]*)`", text)
    for i, part in enumerate(parts):
        part = html.escape(part if i % 2 else part.replace("\\", ""))
        if i % 2:
            parts[i] = f"<code>{part}</code>"
        else:
            part = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", part)
            parts[i] = re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", part)
    return "".join(parts)


def table(heads, rows):
    def cells(row, tag):
        return "".join(f'<{tag}{f" class={chr(34)}{c}{chr(34)}" if c else ""}>{text}</{tag}>' for c, text in row)
    return (f'<div class="wide"><table{" class=many" if len(heads) > 4 else ""}><thead><tr>' + cells(heads, "th") + "</tr></thead><tbody>" +
            "".join("<tr>" + cells(row, "td") + "</tr>\n" for row in rows) + "</tbody></table></div>")


def tables_of(page, heading):
    """[(heads, rows)] of the Markdown tables under a heading of a page."""
    text = page.read_text(encoding="utf-8")
    part = text if heading is None else re.split(r"^## ", text.split(f"\n## {heading}\n", 1)[1], maxsplit=1, flags=re.M)[0]
    for found in re.finditer(r"(?:^\|.*\|\n)+", part, re.M):
        lines = [[cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))] for line in found[0].strip().split("\n")]
        yield lines[0], lines[2:]


def markdown_tables(page, heading, most=None):
    return "".join(table([("", inline(h)) for h in heads], [[("", inline(c)) for c in row] for row in rows])
                   for heads, rows in list(tables_of(page, heading))[:most])


def verdict_class(value):
    return "miss" if value["missed"] else "listed" if value["listed"] and value["judged"] else ""


def value_table(values, profiles, theirs, with_case):
    """A table of (case, value)."""
    with_theirs = any((case, v["quantity"], v["block"], v["time"]) in theirs for case, v in values)
    heads = ([("", "input")] if with_case else []) + [("", "quantity"), ("n", "time"), ("n", "expected")]
    heads += [(f"n {p}", p) for p in profiles] + ([("n", "Berkeley")] if with_theirs else [])
    heads += [(f"n {p}", f"error, {p}") for p in profiles] + [("n", "tolerance"), ("", "verdict")]
    rows = []
    for case, v in values:
        row = [("", html.escape(case.partition("/")[2] or case))] if with_case else []
        row += [("", html.escape(manual.owner_of(v))), ("n", v["time"]), ("n", v["expected"])]
        row += [(f"n ours {p}", v["computed"].get(p) or "–") for p in profiles]
        if with_theirs:
            row.append(("n", theirs.get((case, v["quantity"], v["block"], v["time"]), ("–",))[0]))
        row += [(f"n {p}", v["error"].get(p) or "–") for p in profiles]
        rows.append(row + [("n", v["tolerance"]), (verdict_class(v), html.escape(manual.verdict_of(v)))])
    return table(heads, rows)


def shown_values(found, folder):
    """The values a card shows first: of the pictured input the last of each quantity, judged values first."""
    case = next((c for c in found if c["case"].endswith("/" + folder) or c["case"] == folder), found[0]) if folder else found[0]
    last = {}
    for value in case["values"]:
        key = value["quantity"], value["block"]
        if key not in last or value["judged"] == ["standard"] or last[key]["judged"] != ["standard"]:
            last[key] = value
    return [(case["case"], value) for value in list(last.values())[:ROWS_SHOWN]]


def card(case, rows, results, theirs):
    title, before, _ = manual.readme_of(case)
    topic = manual.topic_of(case)
    physics, source, quantity, legacy, standard, verdict = rows[case]
    found = [c for c in results["cases"] if c["case"].split("/")[0] == case]
    profiles = [p for p in ("legacy", "standard") if any(r["profile"] == p and not r["not_run"] for c in found for r in c["runs"])]
    profiles = profiles or ["legacy"]
    file = manual.MANUAL / f"{case}.svg"
    words = " ".join([case, title, topic, physics, source, quantity]).lower()
    out = [f'<article data-topic="{html.escape(topic)}" data-profiles="{" ".join(profiles)}" data-words="{html.escape(words)}">']
    out.append(f'<div class="picture"><img loading="lazy" alt="{html.escape(title)}" src="{picture(file)}"></div>' if file.is_file() else
               "<div></div>")
    out.append(f'<div><h3>{html.escape(title)}</h3><p class="soft"><span class="tag">{html.escape(topic)}</span> · {inline(physics)}</p>')
    out.append(f"<dl><dt>reference</dt><dd>{inline(source)}</dd><dt>quantity</dt><dd>{inline(quantity)}</dd>"
               f'<dt class="legacy">error, legacy</dt><dd class="legacy">{html.escape(legacy)}</dd>'
               f'<dt class="standard">error, standard</dt><dd class="standard">{html.escape(standard)}</dd>'
               f"<dt>within tolerance</dt><dd>{html.escape(verdict)}</dd></dl>")
    if found:
        shown = shown_values(found, manual.TOPICS[topic][case])
        out.append(f'<p class="soft">Input {html.escape(shown[0][0])}:</p>' + value_table(shown, profiles, theirs, False))
        out.append(f'<p class="soft">Source: {html.escape(manual.expected_rows(shown[0][0])[0]["source"])}</p>')
    elif case == "reference_traces":
        out.append(table([("", "trace"), ("n", "steps"), ("n", "position"), ("n", "stress"), ("", "verdict")],
                         [[("", html.escape(t["trace"].split("/")[-1])), ("n", f"{t['steps']} of {t['steps_in_trace']}"), ("n", t["position"]),
                           ("n", t["stress"]), ("" if t["holds"] else "miss", "ok" if t["holds"] else "missed")] for t in results["traces"]]))
    out.append(f"<pre><code>build/keyblock compare --all legacy_cases/{case}</code></pre></div>")
    values = [(c["case"], v) for c in found for v in c["values"]]
    if len(values) > 1:
        out.append(f"<details><summary>All {len(values)} values of {len(found)} {'input' if len(found) == 1 else 'inputs'}</summary>" +
                   value_table(values, profiles, theirs, True) + "</details>")
    return "\n".join(out) + "</article>"


FIGURES = {"sliding_block": "Sliding block", "arch": "Masonry arch", "arch_map": "Masonry arch: contact stiffness and step",
           "slope": "Jointed slope, 106 blocks", "cantilever": "Cantilever of 64 blocks", "cook": "Cook's membrane"}


def cost():
    figures = "".join(f'<figure><img loading="lazy" alt="{html.escape(name)}" src="{picture(FRONTS / (file + ".svg"))}">'
                      f"<figcaption>{html.escape(name)}</figcaption></figure>" for file, name in FIGURES.items())
    return ('<h2 id="cost">Cost of accuracy</h2><p>Relative error, processor time and, in brackets, that time over the time of the cheapest run'
            " that is as accurate. <code>make fronts</code> measures them; legacy_cases/fronts/README.md explains them.</p>" +
            markdown_tables(FRONTS / "README.md", "Results", 1) + f'<div class="figures">{figures}</div>')


def extremes():
    page = ROOT / "docs" / "random_scenes.md"
    return ('<h2 id="extremes">Random stacks and slopes</h2><p>1,000 scenes from seeds, 40 steps each that may not be shortened, and jointed slopes'
            " of 13 to 516 blocks. docs/random_scenes.md explains the columns and lists the targets that are missed.</p>" +
            markdown_tables(page, None))


def speed():
    page = ROOT / "docs" / "dev" / "performance.md"
    out = ['<h2 id="speed">Speed</h2><p>Processor times of a shared machine; ratios carry over to other machines.'
           " <code>make bench</code> measures them; docs/dev/performance.md explains them.</p>"]
    for heading, text in {"Brick walls": "Time of a step on one thread.",
                          "Crack growth": "Parts of a growth step, in linear solves or factorisations of the same mesh."}.items():
        out.append(f"<h4>{heading}</h4><p>{text}</p>" + markdown_tables(page, heading))
    return "".join(out)


def board():
    results = manual.read_results()
    rows, theirs = manual.index_rows(), manual.berkeley()
    cases = [case for of_topic in manual.TOPICS.values() for case in of_topic]
    values = sum(len(c["values"]) for c in results["cases"])
    variants = sum(len(c["variants"]) for c in results["cases"])
    topics = "".join(f"<option>{html.escape(t)}</option>" for t in manual.TOPICS)
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Keyblock: benchmark board</title><style>{STYLE}</style></head>
<body data-profile=""><header><h1>Keyblock: benchmark board</h1>
<p>{len(cases)} problems, {len(results["cases"])} inputs, {values:,} expected values and {variants} further runs with other steps, contact laws or
functions. Values of {html.escape(results["program"])}. <code>legacy</code> follows Shi's rules, <code>standard</code> today's.</p>
<p class="soft">Errors are the largest of the main runs, relative to the largest expected value of the same quantity and block. “Berkeley”: the Berkeley
program, where its tables have the same input. Values are in the units of the input.</p>
<p><a href="#cost">Cost of accuracy</a> · <a href="#extremes">Random stacks and slopes</a> · <a href="#speed">Speed</a></p></header>
<nav><div><label>topic <select id="topic"><option value="">all</option>{topics}</select></label>
<label>profile <select id="profile"><option value="">both</option><option>legacy</option><option>standard</option></select></label>
<label>search <input id="words" type="search" size="16"></label><span id="shown" class="soft" role="status"></span></div></nav>
<main>
{chr(10).join(card(case, rows, results, theirs) for case in cases)}
{cost()}
{extremes()}
{speed()}
</main><script>{SCRIPT}</script></body></html>
"""


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("-"):
        sys.exit("usage: docs/make_board.py FILE")
    Path(arguments[0]).write_text(board(), encoding="utf-8")
    print(f"board: {arguments[0]}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
