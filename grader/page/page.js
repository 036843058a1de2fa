"use strict";
// The player of a run: shows one step of the table at a time and draws its picture. All numbers and words stand in the
// document; nothing is computed here but places on the screen.
(() => {
  const NS = "http://www.w3.org/2000/svg";
  const MARGIN = 34, WRONG = 4;  // WRONG: as the document numbers how a value stands

  const svgElement = (name, attributes, parent) => {
    const element = document.createElementNS(NS, name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    if (parent) parent.appendChild(element);
    return element;
  };

  // One picture: of the right run (key "r") or of theirs (key "y").
  class Picture {
    constructor(svg, data) {
      this.svg = svg;
      this.data = data;
      this.key = svg.dataset.side === "right" ? "r" : "y";
    }

    // One unit of the picture is one pixel of the screen, so that its letters are as large as the page's.
    measure() {
      this.em = parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;
      this.width = Math.max(this.svg.clientWidth || 480, 200);
      this.height = Math.round(this.width * 0.6875);
      this.svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
      const [x0, y0, x1, y1] = this.data.box, margin = MARGIN * this.em;
      this.scale = Math.min((this.width - 2 * margin) / Math.max(x1 - x0, 1e-9), (this.height - 2 * margin) / Math.max(y1 - y0, 1e-9));
      this.middle = [(x0 + x1) / 2, (y0 + y1) / 2];
    }

    place([x, y]) {
      return [this.width / 2 + (x - this.middle[0]) * this.scale, this.height / 2 - (y - this.middle[1]) * this.scale];
    }

    // Where a point is drawn: at the edge, if it is far off.
    seen(at) {
      const [x, y] = this.place(at);
      const cx = Math.min(Math.max(x, 10), this.width - 10), cy = Math.min(Math.max(y, 10), this.height - 10);
      return { x: cx, y: cy, off: cx !== x || cy !== y };
    }

    line(points, role) {
      const d = points.map((p) => `${p.x.toFixed(1)},${p.y.toFixed(1)}`).join(" ");
      return svgElement("polyline", { points: d, class: role }, this.svg);
    }

    marker(p, role, shape, size) {
      const { x, y } = p, s = size;
      const paths = {
        square: `M${x - s},${y - s}h${2 * s}v${2 * s}h${-2 * s}z`,
        triangle: `M${x},${y - 1.2 * s}L${x + 1.1 * s},${y + 0.8 * s}H${x - 1.1 * s}z`,
        cross: `M${x - s},${y - s}L${x + s},${y + s}M${x - s},${y + s}L${x + s},${y - s}`,
        diamond: `M${x},${y - 1.3 * s}L${x + 1.3 * s},${y}L${x},${y + 1.3 * s}L${x - 1.3 * s},${y}z`,
      };
      if (shape === "disc") svgElement("circle", { cx: x, cy: y, r: s, class: role }, this.svg);
      else svgElement("path", { d: paths[shape], class: role }, this.svg);
      this.taken.push([x - s, y - s, x + s, y + s]);
    }

    draw(step) {
      this.measure();
      const { points, lines, steps, curve } = this.data;
      const now = steps[step];
      const own = this.key === "y";
      this.svg.replaceChildren();
      this.taken = [];
      const there = points.map((p) => p[this.key] && p.s <= step && (p.e === undefined || step < p.e));
      const at = points.map((p, i) => there[i] && this.seen(p[this.key]));
      for (const piece of curve || []) {
        const samples = [];
        for (let i = 0; i < piece.length; i += 2) samples.push(piece.slice(i, i + 2));
        this.line(samples.map((s) => { const [x, y] = this.place(s); return { x, y }; }), "curve");
      }
      for (const row of lines) {
        let run = [];
        const finish = () => { if (run.length > 1) this.line(run.map((i) => at[i]), "polygon " + this.role(points[run[0]])); run = []; };
        for (const i of row) { if (there[i]) run.push(i); else finish(); }
        finish();
      }
      const operands = (now.o || []).filter((i) => there[i]);
      if (now.v !== undefined && operands.length > 1)
        this.line(operands.map((i) => at[i]), "operands");
      const departs = own && now.v !== undefined && there[now.v] && points[now.v].k === WRONG;
      if (departs && points[now.v].w) {
        const would = this.seen(points[now.v].w);
        this.line([would, at[now.v]], "departure");
        svgElement("circle", { cx: would.x, cy: would.y, r: 7, class: "expected" }, this.svg);
      }
      points.forEach((p, i) => {
        if (!there[i] || i === now.v) return;
        if (p.l === -2 && p.s < step && !operands.includes(i) && step + 1 < steps.length) return;
        const wrong = own && p.k === WRONG;
        const [shape, size] = wrong ? ["cross", 5] : p.l <= 0 ? ["disc", 4] : [["disc", 4.5], ["square", 4], ["triangle", 5]][(p.l - 1) % 3];
        this.marker(at[i], wrong ? "mistake" : this.role(p), shape, size);
        if (!operands.includes(i)) return;
        const { x, y } = at[i], r = 9.5;
        svgElement("circle", { cx: x, cy: y, r, class: "operand" }, this.svg);
        this.taken.push([x - r, y - r, x + r, y + r]);
      });
      if (now.v !== undefined && there[now.v])
        this.marker(at[now.v], departs ? "mistake now" : "current", departs ? "cross" : "disc", departs ? 8 : 7.5);
      this.labels(there, at, now, operands);
    }

    role(p) {
      return p.l === 0 ? "control" : p.l < 0 ? "made" : "level-" + "abc"[(p.l - 1) % 3];
    }

    // The step's point first, then what it is made from, then the others as far as there is room.
    labels(there, at, now, operands) {
      const { points } = this.data;
      const order = [now.v, ...operands].filter((i) => i !== undefined && there[i]);
      const control = points.map((p, i) => i).filter((i) => there[i] && points[i].l >= -1 && !order.includes(i))
        .sort((a, b) => points[b].s - points[a].s || a - b);
      for (const i of order) this.label(points[i], at[i], i === now.v ? "label current" : "label strong", true);
      for (const i of control) this.label(points[i], at[i], "label", false);
    }

    label(point, p, role, must) {
      const size = (role === "label" ? 14 : 16) * this.em;
      const stacked = point.n.length > 2;
      const width = point.n.reduce((sum, [text, level], n) =>
        level === 0 ? sum + size * 0.62 * text.length : stacked && n === 1 ? sum : sum + size * 0.42 * text.length, 0) + 2;
      const distance = role === "label strong" ? 11 : 8;
      // Around the point, and where that is taken, farther off.
      const around = [[1, -1], [-1, -1], [1, 1], [-1, 1], [0, -1.5], [0, 1.5], [1.4, 0], [-1.4, 0]];
      const far = must ? [1, 1.9, 3] : [1];
      const spots = far.flatMap((f) => around.map(([dx, dy]) => [dx * f, dy * f])).map(([dx, dy]) => {
        const x = dx > 0 ? p.x + distance * dx : dx < 0 ? p.x - width + distance * dx : p.x - width / 2;
        const y = p.y + (dy > 0 ? size + distance * dy * 0.6 : dy < 0 ? distance * dy * 0.9 : size * 0.35);
        return [x, y - size, x + width, y + 4, x, y];
      });
      const inside = (b) => b[0] >= 2 && b[1] >= 0 && b[2] <= this.width - 2 && b[3] <= this.height - 1;
      const meets = (b) => this.taken.filter((t) => b[0] < t[2] && t[0] < b[2] && b[1] < t[3] && t[1] < b[3]).length;
      const crossings = (b) => this.segments().filter((s) => crosses(b, s)).length;
      let best = null, least = Infinity;
      for (const spot of spots) {
        const cost = meets(spot) * 10 + crossings(spot) + (inside(spot) ? 0 : 100);
        if (cost < least) { best = spot; least = cost; }
      }
      // Two names at one place can be read less than none.
      if (least >= (role === "label current" ? 100 : 10)) return;
      this.taken.push(best);
      const text = svgElement("text", { x: best[4].toFixed(1), y: best[5].toFixed(1), class: role, "font-size": size }, this.svg);
      let lift = 0, back = 0;
      for (const [content, level] of point.n) {
        const wanted = level === 1 ? size * 0.3 : level === 2 ? -size * 0.45 : 0;
        const span = svgElement("tspan", { dy: (wanted - lift).toFixed(1) }, text);
        if (level === 0) span.setAttribute("font-style", "italic");
        else span.setAttribute("font-size", (size * 0.7).toFixed(1));
        if (level === 2 && back > 0) span.setAttribute("dx", (-back).toFixed(1));
        span.textContent = content;
        back = level === 1 ? content.length * size * 0.7 * 0.56 : 0;
        lift = wanted;
      }
      if (p.off) svgElement("title", {}, text).textContent = "outside of the picture";
    }

    segments() {
      if (this.taken.segments) return this.taken.segments;
      const found = [];
      for (const line of this.svg.querySelectorAll("polyline")) {
        const p = line.getAttribute("points").split(" ").map((pair) => pair.split(",").map(Number));
        for (let i = 0; i + 1 < p.length; ++i) found.push([...p[i], ...p[i + 1]]);
      }
      return (this.taken.segments = found);
    }
  }

  // Whether a segment meets a box, by clipping it (Liang and Barsky).
  function crosses([x0, y0, x1, y1], [ax, ay, bx, by]) {
    let from = 0, to = 1;
    for (const [d, low, high] of [[bx - ax, x0 - ax, x1 - ax], [by - ay, y0 - ay, y1 - ay]]) {
      if (d === 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      from = Math.max(from, Math.min(low / d, high / d));
      to = Math.min(to, Math.max(low / d, high / d));
    }
    return from < to;
  }

  class Player {
    constructor(section) {
      this.root = section.querySelector(".player");
      this.rows = [...section.querySelectorAll("table.steps tbody tr")];
      this.heads = [...section.querySelectorAll("table.steps thead th")].map((th) => th.textContent);
      this.cells = [...section.querySelectorAll("table.scheme td[data-v]")];
      this.range = this.root.querySelector("input");
      this.output = this.root.querySelector("output");
      this.told = this.root.querySelector(".told");
      const json = section.querySelector("script.picture");
      const data = json && JSON.parse(json.textContent);
      this.steps = data ? data.steps : this.rows.map(() => ({}));
      this.pictures = data ? [...section.querySelectorAll("svg.picture")].map((svg) => new Picture(svg, data)) : [];
      this.step = 0;
      this.root.hidden = false;
      this.root.addEventListener("click", (event) => {
        const button = event.target.closest("button");
        if (button) this.go(button.dataset.go);
      });
      this.range.addEventListener("input", () => this.show(this.range.value - 1));
      this.show(0);
      if (this.pictures.length > 0)
        new ResizeObserver(() => this.pictures.forEach((picture) => picture.draw(this.step))).observe(this.root);
    }

    go(where) {
      const last = this.rows.length - 1;
      this.show({ first: 0, back: this.step - 1, next: this.step + 1, last }[where]);
    }

    show(step) {
      const last = this.rows.length - 1;
      this.step = Math.min(Math.max(step, 0), last);
      const row = this.rows[this.step];
      this.range.value = this.step + 1;
      this.range.setAttribute("aria-valuetext", `step ${this.step + 1} of ${last + 1}`);
      this.output.textContent = `${this.step + 1} of ${last + 1}`;
      for (const button of this.root.querySelectorAll("button")) {
        const back = button.dataset.go === "first" || button.dataset.go === "back";
        button.setAttribute("aria-disabled", back ? this.step === 0 : this.step === last);
      }
      this.told.replaceChildren(...[...row.cells].slice(1).map((cell, i) => {
        const block = document.createElement("div");
        block.className = cell.className;
        if (i > 0 && cell.childNodes.length > 0) {
          const head = document.createElement("h4");
          head.textContent = this.heads[i + 1];
          block.append(head);
        }
        block.append(...[...cell.childNodes].map((node) => node.cloneNode(true)));
        return block;
      }));
      this.rows.forEach((each) => each.classList.toggle("shown", each === row));
      const [made, ...from] = this.steps[this.step].c || [];
      for (const cell of this.cells) {
        const v = +cell.dataset.v;
        cell.classList.toggle("now", v === made);
        cell.classList.toggle("from", from.includes(v));
        // At first the whole scheme is there to be read.
        cell.classList.toggle("later", this.step > 0 && this.comesLater(v));
      }
      for (const picture of this.pictures) picture.draw(this.step);
    }

    comesLater(v) {
      const made = this.steps.findIndex((step) => step.c && step.c[0] === v);
      return made > this.step;
    }
  }

  const players = [...document.querySelectorAll("section.run")].map((section) => new Player(section));
  let active = players[0];
  for (const player of players)
    for (const kind of ["focusin", "pointerdown"]) player.root.addEventListener(kind, () => (active = player));

  // Arrow keys work anywhere on the page; Home and End, which scroll it, only in a player.
  document.addEventListener("keydown", (event) => {
    if (!active || event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
    const inside = active.root.contains(event.target);
    if (!inside && event.target.closest && event.target.closest(".scroll")) return;
    const action = { ArrowLeft: "back", ArrowRight: "next", Home: inside && "first", End: inside && "last" }[event.key];
    if (!action) return;
    event.preventDefault();
    active.go(action);
  });

  // The table is there for print and for whoever has no script; here it can wait.
  const details = [...document.querySelectorAll("details.all")];
  for (const each of details) each.open = false;
  // On paper the pictures are those of the whole run.
  addEventListener("beforeprint", () => {
    for (const each of document.querySelectorAll("details")) each.open = true;
    for (const player of players) {
      player.left ??= player.step;
      player.go("last");
    }
  });
  addEventListener("afterprint", () => {
    for (const player of players) {
      player.show(player.left ?? player.step);
      player.left = undefined;
    }
  });
})();
