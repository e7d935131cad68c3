// Draws the formulas of a page by KaTeX, from files beside this one.
(function () {
  const here = document.currentScript.src.replace(/[^/]*$/, "");
  const style = document.createElement("link");
  style.rel = "stylesheet";
  style.href = here + "katex.min.css";
  document.head.append(style);
  const load = (name) =>
    new Promise((done) => {
      const script = document.createElement("script");
      script.src = here + name;
      script.onload = done;
      document.head.append(script);
    });
  load("katex.min.js").then(() => {
    for (const place of document.querySelectorAll(".math")) {
      const isDisplay = place.tagName === "DIV";
      const text = place.textContent.trim().replace(/^\\[[(]/, "").replace(/\\[\])]$/, "");
      katex.render(text, place, { displayMode: isDisplay, throwOnError: false });
    }
  });
})();
