// SPDX-License-Identifier: GPL-3.0-or-later
// The filter of the gallery: figures whose heading, text or input has every word that is typed. gallery.html?filter=rubber+map begins with it.
(() => {
  // The parts of the page: each heading with what follows it up to the next one.
  const sectionsOf = (article) => {
    const sections = [];
    for (const part of article.children) {
      if (part.tagName === "H2" || part.tagName === "H3") {
        sections.push({ level: part.tagName, parts: [] });
      }
      if (sections.length > 0) {
        sections[sections.length - 1].parts.push(part);
      }
    }
    return sections;
  };

  const show = (section, isShown) => section.parts.forEach((part) => { part.hidden = !isShown; });

  // Show the figures that have all words, and the headings above them; how many these are.
  const filter = (sections, text) => {
    const words = text.toLowerCase().split(/\s+/).filter((word) => word);
    let above = null;
    let count = 0;
    for (const section of sections) {
      if (section.level === "H2") {
        above = section;
        show(above, words.length === 0);
        continue;
      }
      const has = section.parts.map((part) => part.textContent).concat(above ? above.parts[0].textContent : "").join(" ").toLowerCase();
      const isShown = words.every((word) => has.includes(word));
      show(section, isShown);
      if (isShown) {
        count += 1;
        if (above) { show(above, true); }
      }
    }
    return count;
  };

  const begin = () => {
    const article = document.querySelector("article");
    if (!article || !/\/gallery\.html$/.test(location.pathname) || document.getElementById("gallery-filter")) { return; }
    const sections = sectionsOf(article);
    const input = document.createElement("input");
    const count = document.createElement("span");
    input.id = "gallery-filter";
    input.type = "search";
    input.placeholder = "Filter: rubber, adhesion, sphere, map ...";
    input.setAttribute("aria-label", "Filter of the gallery");
    input.value = new URLSearchParams(location.search).get("filter") || "";
    count.id = "gallery-count";
    const update = () => { const n = filter(sections, input.value); count.textContent = n === 1 ? "1 figure" : `${n} figures`; };
    input.addEventListener("input", update);
    sections[0].parts[0].before(input, count);
    update();
  };

  if (document.readyState === "loading") {
    document.addEventListener("DOMContentLoaded", begin);
  } else {
    begin();
  }
})();
