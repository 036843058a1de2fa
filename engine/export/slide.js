// The sliders of a step. The page runs no algorithm: for each of their stops it has the step as the run with these
// numbers makes it.
class Sliders {
  // `onMove` is called when another stop is to be shown.
  constructor(block, onMove) {
    this.block = block;
    this.onMove = onMove;
    this.step = null;
  }

  // At the lesson's own numbers. `item`: of the document's list of steps; `step`: of the lesson's data.
  open(item, step) {
    const {word, element, copies} = Questions;
    this.step = step;
    this.at = [...(step.a?.start ?? [])];
    this.block.hidden = !step.a;
    this.block.replaceChildren(...(step.a ? copies(item.querySelector("template.sliders")) : []));
    if (!step.a) return;
    this.inputs = [...this.block.querySelectorAll("input")];
    this.inputs.forEach((input, i) => input.addEventListener("input", () => this.move(i, +input.value)));
    const reset = element("button", {type: "button", onclick: () => this.reset()}, word("reset"));
    const note = step.q ? [element("p", {class: "quiet"}, word("asksown"))] : [];
    this.away = element("div", {class: "away", hidden: true}, reset, ...note);
    this.block.append(this.away);
  }

  // The place in the page's list of stops; null: the step itself, -1: nothing is there.
  stop(at = this.at) {
    const {values, stops} = this.step?.a ?? {};
    return stops ? stops[at.reduce((place, each, i) => place * values[i].length + each, 0)] : null;
  }
  moved() { return this.stop() !== null; }

  // Where nothing is, the slider goes on in its direction, as far as there is anything.
  move(which, to) {
    const {values} = this.step.a, by = Math.sign(to - this.at[which]);
    const is = (place) => this.stop(this.at.map((each, i) => (i === which ? place : each))) !== -1;
    let place = to;
    while (by !== 0 && place >= 0 && place < values[which].length && !is(place)) place += by;
    if (!values[which][place]) for (place = to; !is(place);) place -= by;
    const other = place !== this.at[which];
    this.at[which] = place;
    this.write();
    if (other) this.onMove();
  }

  reset() {
    this.at = [...this.step.a.start];
    this.write();
    this.inputs[0].focus();
    this.onMove();
  }

  write() {
    this.inputs.forEach((input, i) => {
      const text = this.step.a.values[i][this.at[i]];
      input.value = this.at[i];
      input.setAttribute("aria-valuetext", text);
      input.closest(".slider").querySelector("b").textContent = text;
    });
    this.away.hidden = !this.moved();
  }
}
