// What is drawn of a step: pictures of shared elements, the triangular scheme, the table of values.
const Shown = (() => {
  const {lesson, word, element} = Questions;
  const SVG = "http://www.w3.org/2000/svg";

  // ---- pictures -------------------------------------------------------------------------------------------------

  const node = (name, attributes, parent) => {
    const made = document.createElementNS(SVG, name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    parent?.append(made);
    return made;
  };

  const drawn = (e) => {
    if (typeof e[0] === "number") {
      const group = node("g", {opacity: e[0]});
      for (const [style, d] of e[1]) node("path", {class: style, d}, group);
      return group;
    }
    const [style, what] = e;
    if (typeof what === "string") return node("path", {class: style, d: what});
    if (!Array.isArray(what)) return node("circle", {class: style, cx: what, cy: e[2], r: e[3]});
    // The halos of all letters first, so that none covers its neighbour.
    const both = node("g", {class: style});
    const text = node("text", {class: "letters"});
    for (const [x, y, size, words, flags = 0] of what) {
      const run = node("tspan", {x, y, "font-size": size}, text);
      if (flags & 1) run.setAttribute("font-weight", "bold");
      if (flags & 2) run.setAttribute("font-style", "italic");
      if (flags & 4) run.setAttribute("font-family", "DejaVu Sans Mono, monospace");
      run.textContent = words;
    }
    const halo = text.cloneNode(true);
    halo.setAttribute("class", "halo");
    both.append(halo, text);
    return both;
  };

  // Elements that are shown again are not made again.
  class Picture {
    constructor(svg) {
      this.svg = svg;
      this.made = new Map();
    }
    draw(numbers, [width, height]) {
      this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
      if (this.made.size > 4000) this.made.clear();
      const used = new Set();
      this.svg.replaceChildren(...numbers.map((n) => {
        if (!this.made.has(n)) this.made.set(n, drawn(lesson.elements[n]));
        const twice = used.has(n);
        used.add(n);
        return twice ? this.made.get(n).cloneNode(true) : this.made.get(n);
      }));
    }
  }

  // ---- the triangular scheme, or the table of values ------------------------------------------------------------

  class Sheet {
    constructor(card) {
      this.card = card;
      this.title = card.querySelector("h2");
      this.scroll = card.querySelector(".scroll");
      this.sheet = card.querySelector(".sheet");
      this.home = null;  // where the scheme that is shown belongs in the document
      new ResizeObserver(() => this.arrows()).observe(this.sheet);
    }

    giveBack() {
      if (this.home) this.home.append(this.sheet.querySelector("table"));
      this.home = null;
      this.table = this.step = null;
      this.sheet.replaceChildren();
    }

    show(section, step) {
      if (step.t !== undefined) this.scheme(section, step);
      else this.values(section, step);
    }

    scheme(section, step) {
      const home = section.querySelector(".parts");
      const wanted = `table.scheme[data-t="${step.t}"]`;
      if (this.home !== home || !this.sheet.querySelector(wanted)) {
        this.giveBack();
        this.home = home;
        this.table = home.querySelector(wanted);
        this.lines = node("svg", {"aria-hidden": "true", class: "arrows"});
        this.sheet.append(this.table, this.lines);
      }
      this.card.hidden = false;
      this.title.textContent = word("scheme");
      this.scroll.setAttribute("aria-label", word("scheme"));
      this.step = step;
      for (const cell of this.table.querySelectorAll("td[data-v]")) {
        const v = +cell.dataset.v, later = +cell.dataset.s > step.n;
        cell.classList.toggle("later", later);
        cell.firstElementChild.setAttribute("aria-hidden", later);
        cell.classList.toggle("now", v === step.v);
        cell.classList.toggle("from", !!step.o?.includes(v));
        if (v === step.v) cell.setAttribute("aria-current", "step");
        else cell.removeAttribute("aria-current");
      }
      this.arrows();
      this.follow();
    }

    // From the operands to what is made of them, with their shares.
    arrows() {
      if (!this.table || !this.step) return;
      const frame = this.sheet.getBoundingClientRect();
      const box = (v) => {
        const cell = this.table.querySelector(`td[data-v="${v}"]`)?.firstElementChild;
        if (!cell) return null;
        const b = cell.getBoundingClientRect();
        return {left: b.left - frame.left, right: b.right - frame.left, y: (b.top + b.bottom) / 2 - frame.top};
      };
      this.lines.setAttribute("viewBox", `0 0 ${Math.max(frame.width, 1)} ${Math.max(frame.height, 1)}`);
      this.lines.replaceChildren();
      const to = this.step.v === undefined ? null : box(this.step.v);
      if (!to) return;
      (this.step.o ?? []).forEach((v, i) => {
        const from = box(v);
        if (!from || from.right > to.left) return;
        node("path", {d: `M${from.right + 2} ${from.y}L${to.left - 2} ${to.y}`}, this.lines);
        const share = this.step.x[i];
        if (!share) return;
        // Where the two lines are not yet near each other.
        const t = 0.42;
        const x = from.right + t * (to.left - from.right), y = from.y + t * (to.y - from.y) + 4;
        node("text", {x, y}, this.lines).textContent = share;
      });
    }

    follow() {
      const cell = this.table.querySelector("td.now");
      if (!cell) return;
      const frame = this.scroll.getBoundingClientRect(), b = cell.getBoundingClientRect();
      if (b.left < frame.left + 90 || b.right > frame.right)
        this.scroll.scrollLeft += (b.left + b.right - frame.left - frame.right) / 2;
      if (b.top < frame.top || b.bottom > frame.bottom)
        this.scroll.scrollTop += (b.top + b.bottom - frame.top - frame.bottom) / 2;
    }

    values(section, step) {
      this.giveBack();
      const rows = section.querySelector("template.values").content.querySelectorAll("tr");
      const body = element("tbody", {}, ...(step.g ?? []).map((row, i) => {
        const made = rows[row].cloneNode(true);
        if (step.h?.includes(i)) {
          made.className = "now";
          made.setAttribute("aria-current", "step");
        }
        return made;
      }));
      const title = word(step.n === 0 ? "given" : "values");
      // One value that this step makes stands beside it already.
      this.card.hidden = body.childElementCount === 0 || (body.childElementCount === 1 && step.h);
      this.title.textContent = title;
      this.scroll.setAttribute("aria-label", title);
      this.sheet.append(element("table", {class: "values"}, body));
      const now = body.querySelector(".now");
      if (now) this.scroll.scrollTop = now.offsetTop - this.scroll.clientHeight / 2;
    }
  }

  return {node, Picture, Sheet};
})();
