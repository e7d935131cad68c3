// Holds the look of documents: black on white in print; light or dark on a screen, as the reader has chosen.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace keyblock::report {

inline constexpr std::string_view kDocumentStyle = R"(
:root { color-scheme: light dark; --text: #1d2330; --faint: #5b6472; --line: #d5dae2; --back: #fff; --head: #f3f5f8 }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6e9ef; --faint: #a7b0be; --line: #3a4250; --back: #14181f; --head: #1e242e }
}
* { box-sizing: border-box }
body { font: 15px/1.5 system-ui, "DejaVu Sans", Helvetica, Arial, sans-serif; color: var(--text);
  background: var(--back); max-width: 60rem; margin: 0 auto; padding: 1.5rem 1.25rem 4rem }
h1 { font-size: 1.7rem; margin: 0 } h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; break-after: avoid }
.subtitle { color: var(--faint); margin: .2rem 0 1rem }
.verdict { border-left: 6px solid; padding: .6rem .9rem; background: var(--head); border-radius: 0 6px 6px 0 }
.good { border-color: #1a7f4b } .doubtful { border-color: #b26a00 } .bad { border-color: #b3261e }
nav { margin: 1rem 0; color: var(--faint) } a { color: inherit }
nav a { margin-right: 1rem; white-space: nowrap }
.scroll { overflow-x: auto; margin: .6rem 0 } table { border-collapse: collapse; width: 100%; font-size: .92em }
th, td { text-align: left; padding: .25rem .6rem .25rem 0; border-bottom: 1px solid var(--line);
  vertical-align: top; overflow-wrap: break-word }
th { font-weight: 600; background: var(--head); overflow-wrap: normal }
.number { text-align: right; font-variant-numeric: tabular-nums } td.number { white-space: nowrap }
.facts { display: flex; flex-wrap: wrap; gap: .3rem 2rem; margin: 0 0 1rem }
.facts div { display: flex; gap: .5rem } dt { color: var(--faint) } dd { margin: 0; overflow-wrap: anywhere }
.wide { max-width: 80rem } td.code { overflow-wrap: anywhere } .card .links a { text-decoration: underline }
.filter { display: flex; flex-wrap: wrap; gap: .5rem 1rem; align-items: center; margin: 1rem 0 }
.filter input, .filter select { font: inherit; color: inherit; background: var(--head); border: 1px solid var(--line);
  border-radius: 6px; padding: .3rem .5rem; min-width: 0 }
.cards { list-style: none; display: grid; grid-template-columns: repeat(auto-fill, minmax(min(18rem, 100%), 1fr));
  gap: 1rem; padding: 0; margin: 0 0 2rem }
.card { border: 1px solid var(--line); border-top: 4px solid; border-radius: 8px; padding: .5rem .7rem; min-width: 0 }
.card.good { border-top-color: #1a7f4b } .card.doubtful { border-top-color: #b26a00 }
.card.bad { border-top-color: #b3261e } .card[hidden] { display: none }
.card a { text-decoration: none } .card a:hover b { text-decoration: underline }
.card img, .card .none { display: block; width: 100%; aspect-ratio: 11 / 7; object-fit: contain; background: #fff;
  border-radius: 4px; margin-bottom: .4rem }
.card .none { color: #5b6472; padding: .5rem } .card b { overflow-wrap: anywhere }
.card > span { display: block; font-size: .88em; color: var(--faint); overflow-wrap: anywhere }
.card .ends { display: grid; grid-template-columns: 1fr 1fr; gap: .5rem; margin: .4rem 0; font-size: .82em }
.card .ends img { margin-bottom: 0; object-fit: cover; object-position: top }
th button { all: unset; cursor: pointer } th button:focus-visible { outline: 2px solid }
figure { margin: 1rem 0; break-inside: avoid } figcaption { color: var(--faint); font-size: .9em }
figure img { width: 100%; background: #fff; border: 1px solid var(--line) }
@media screen and (prefers-color-scheme: dark) {
  .card img, figure img { filter: invert(.91) hue-rotate(180deg) } /* black on white becomes light on dark */
  .card .none { color: var(--faint); background: var(--head) } }
@media screen and (max-width: 30rem) { body { padding: 1rem .75rem 3rem }
  table { font-size: .8em } th, td { padding-right: .35rem } }
@media print {
  @page { size: A4; margin: 16mm } body { font-size: 10pt; padding: 0; max-width: none } nav, .filter { display: none }
  figure img { width: auto; max-width: 100%; max-height: 150mm }
  .card { break-inside: avoid } td { overflow-wrap: anywhere }
  tr { break-inside: avoid } :root { --text: #000; --faint: #444; --line: #bbb; --back: #fff; --head: #f3f3f3 } }
)";

/// Fields that sift the cards, by words and by verdict; the choices of verdicts stand at the braces.
inline constexpr std::string_view kCardFilter = R"(<div class="filter">
<label>Words <input id="words" type="search"></label>
<label>Verdict <select id="verdict"><option value="">all</option>
{}</select></label>
<output id="count" aria-live="polite"></output></div>
)";

inline constexpr std::string_view kCardScript = R"(
const cards = [...document.querySelectorAll(".card")];
const words = document.querySelector("#words"), verdict = document.querySelector("#verdict");
function sift() {
  let shown = 0;
  for (const card of cards) {
    card.hidden = !card.textContent.toLowerCase().includes(words.value.toLowerCase()) ||
      (verdict.value !== "" && card.dataset.state !== verdict.value);
    shown += card.hidden ? 0 : 1;
  }
  document.querySelector("#count").textContent = shown + " of " + cards.length;
}
words.oninput = verdict.onchange = sift;
sift();
// A click on a heading sorts the rows: numbers as numbers, all else as text; a second click reverses the order.
for (const table of document.querySelectorAll("table"))
  table.querySelectorAll("th").forEach((heading, column) => {
    const button = document.createElement("button");
    button.append(...heading.childNodes);
    heading.append(button);
    button.onclick = () => {
      const turn = heading.ariaSort === "ascending" ? -1 : 1;
      for (const other of heading.parentNode.children) other.removeAttribute("aria-sort");
      heading.ariaSort = turn > 0 ? "ascending" : "descending";
      const value = row => row.cells[column].textContent;
      const body = table.tBodies[0];
      body.append(...[...body.rows].sort((a, b) => {
        const x = value(a), y = value(b);
        return turn * (x !== "" && y !== "" && !isNaN(x) && !isNaN(y) ? x - y : x < y ? -1 : x > y ? 1 : 0);
      }));
    };
  });
)";

}  // namespace keyblock::report
