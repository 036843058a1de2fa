// The player of a lesson: one step at a time. All words stand in the document's list of steps, and are shown from
// there; pictures are numbers of elements that all steps share.
(() => {
  const {lesson, word, element, copies} = Questions;
  const {node, Picture, Sheet} = Shown;
  const root = document.documentElement;
  root.classList.add("scripted");
  for (const each of document.querySelectorAll(".js")) each.hidden = false;
  const find = (selector) => document.querySelector(selector);
  const sections = [...document.querySelectorAll("section.scene")];

  // ---- where one is ---------------------------------------------------------------------------------------------

  const picture = new Picture(find("#picture")), knots = new Picture(find("#knots"));
  const sheet = new Sheet(find(".card.scheme"));
  const bar = find(".bar"), range = bar.querySelector("input"), where = bar.querySelector("output");
  const marks = bar.querySelector(".marks"), speed = bar.querySelector("select");
  const card = (name) => find(`.card.${name}`);
  const roomy = matchMedia("(min-width: 38rem) and (min-height: 30.01rem)");
  const told = find(".told"), question = find(".question");
  let scene = 0, at = 0, playing = null, left = null;

  const steps = () => lesson.scenes[scene].steps;
  const step = () => steps()[at];
  const stops = [...document.querySelectorAll("template.stop")].map((each) => each.content);
  const items = sections.map((section) => [...section.querySelectorAll("ol.steps > li")]);
  const item = () => items[scene][at];
  const sliders = new Sliders(find(".sliders"), () => {
    setPlaying(false);
    // Only the slider says its number aloud, and it stays in its place while the words above it become fewer.
    told.setAttribute("aria-live", "off");
    told.style.minHeight = `${told.offsetHeight}px`;
    show();
  });
  // What is shown: the step, or what it is at a stop of its sliders.
  const seen = () => {
    const stop = sliders.stop();
    if (stop === null) return {now: step(), from: item(), parts: sections[scene], size: lesson.scenes[scene].size};
    const {steps: [now], size} = lesson.stops[stop], parts = stops[stop];
    return {now, from: parts.querySelector("li"), parts, size};
  };

  const fill = (target, source) => {
    target.hidden = !source;
    target.replaceChildren(...(source ? copies(source) : []));
  };

  const drawPictures = () => {
    const {now, size} = seen(), wide = roomy.matches;
    picture.draw(wide ? now.w : now.s, wide ? size.w : size.s);
    find(".knots").hidden = !now.k;
    if (now.k) knots.draw(wide ? now.k : now.l, wide ? size.k : size.l);
  };

  const showCode = () => {
    const {now} = seen();
    const code = sections[scene].querySelector(`ol.code[data-c="${now.c}"]`);
    const shown = card("code").lastElementChild;
    card("code").hidden = !code;
    // Where there are no knots, there is room below the picture.
    const place = find(now.k ? ".side" : ".more");
    if (card("code").parentNode !== place) now.k ? place.append(card("code")) : place.prepend(card("code"));
    if (shown.firstElementChild?.dataset.c !== String(now.c) || shown.scene !== scene) {
      shown.scene = scene;
      shown.replaceChildren(...(code ? [code.cloneNode(true)] : []));
    }
    [...shown.querySelectorAll("li")].forEach((line, i) => {
      if (i + 1 === now.f) line.setAttribute("aria-current", "step");
      else line.removeAttribute("aria-current");
    });
    return shown.firstElementChild;
  };

  const show = () => {
    const {n, q} = step(), {now, from, parts} = seen(), last = steps().at(-1).n;
    const says = from.querySelector(".say"), phase = from.querySelector(".phase");
    drawPictures();
    const place = word("picture", {n});
    picture.svg.setAttribute("aria-label", `${place}: ${says.textContent.replace(/\s+/g, " ").trim()}`);
    fill(find(".told .phase"), phase);
    fill(find(".told .say"), says);
    const formula = from.querySelector(".formula:not(.say .formula)");
    card("formula").hidden = !formula;
    fill(card("formula").lastElementChild, formula);
    const code = showCode();
    sheet.show(parts, now);
    // What was typed stays while the sliders are elsewhere.
    question.hidden = sliders.moved();
    if (!question.hidden && (question.of !== item() || question.code !== code)) {
      question.of = item();
      question.code = code;
      question.replaceChildren(...(q ? [Questions.show(q, item(), code)] : []));
    }

    range.max = steps().length - 1;
    range.value = at;
    const words = word("of", {n, last});
    range.setAttribute("aria-valuetext", words);
    where.textContent = `${n} / ${last}`;
    where.title = words;
    const isFirst = at === 0 && scene === 0, isLast = at === steps().length - 1 && scene === sections.length - 1;
    for (const button of bar.querySelectorAll("button[data-go]")) {
      const {go} = button.dataset;
      const still = go === "first" || go === "back" || go === "beatback" ? isFirst : go !== "play" && isLast;
      button.setAttribute("aria-disabled", still);
    }
    for (const list of items)
      for (const each of list) each.classList.toggle("shown", each === item());
    sections.forEach((section, i) => section.classList.toggle("shown", i === scene));
    for (const tab of document.querySelectorAll(".scenes button")) {
      if (+tab.dataset.scene === scene) {
        tab.setAttribute("aria-current", "true");
        const row = tab.parentNode;
        row.scrollLeft = tab.offsetLeft - row.offsetLeft - (row.clientWidth - tab.offsetWidth) / 2;
      } else tab.removeAttribute("aria-current");
    }
    const {id} = lesson.scenes[scene];
    try {
      history.replaceState(null, "", `#${id ? id + "-" : ""}${n}`);
    } catch { /* it is only the address */
    }
  };

  const drawMarks = () => {
    const last = Math.max(steps().length - 1, 1);
    marks.replaceChildren(...steps().flatMap((each, i) => {
      if (!each.b && !each.q) return [];
      const state = !each.q            ? "beat" :
          Questions.isOpen(each.q.id)  ? "query" :
          Questions.isRight(each.q.id) ? "query right" :
                                         "query wrong";
      const mark = element("i", {class: state});
      mark.style.left = `${(100 * i) / last}%`;
      return [mark];
    }));
    const beats = steps().filter((each) => each.b).length;
    for (const button of bar.querySelectorAll(".beats")) button.hidden = beats === 0 || beats === steps().length;
  };

  const go = (to, step_index) => {
    const other = to !== scene;
    scene = Math.min(Math.max(to, 0), sections.length - 1);
    at = Math.min(Math.max(step_index, 0), steps().length - 1);
    if (other) drawMarks();
    told.setAttribute("aria-live", "polite");
    told.style.minHeight = "";
    sliders.open(item(), step());
    show();
  };

  const beat = (by) => {
    for (let s = scene, i = at + by;
         s >= 0 && s<sections.length; s += by, i = by>0 ? 0 : lesson.scenes[s]?.steps.length - 1) {
      const list = lesson.scenes[s].steps;
      for (; i >= 0 && i < list.length; i += by)
        if (list[i].b) return go(s, i);
    }
    go(by > 0 ? sections.length - 1 : 0, by > 0 ? Infinity : 0);
  };

  const moves = {
    first: () => go(scene, 0),
    last: () => go(scene, Infinity),
    back: () => (at > 0 || scene === 0 ? go(scene, at - 1) : go(scene - 1, Infinity)),
    next: () => (at < steps().length - 1 || scene === sections.length - 1 ? go(scene, at + 1) : go(scene + 1, 0)),
    beatback: () => beat(-1),
    beatnext: () => beat(1),
  };

  // ---- playing --------------------------------------------------------------------------------------------------

  // As long as it takes to read: a third of a second for each word.
  const seconds = () => {
    const count = item().querySelector(".say").textContent.trim().split(/\s+/).length;
    const reading = step().b ? Math.min(1.2 + 0.3 * count, 16) : 1.6;
    return (reading + Math.max(step().p ?? 0, 0)) / +speed.value;
  };
  const waits = () => step().p === -1 || (step().q && Questions.isOpen(step().q.id));
  const atEnd = () => at === steps().length - 1 && scene === sections.length - 1;
  const setPlaying = (on) => {
    clearTimeout(playing);
    playing = on ? setTimeout(tick, 1000 * seconds()) : null;
    const button = bar.querySelector(".play"), name = word(on ? "pause" : "play");
    button.classList.toggle("playing", on);
    button.setAttribute("aria-label", name);
    button.title = name;
  };
  function tick() {
    moves.next();
    setPlaying(!atEnd() && !waits());
  }
  const play = () => {
    if (playing) return setPlaying(false);
    if (atEnd()) go(0, 0);
    setPlaying(true);
  };
  const act = (name) => {
    if (name === "play") return play();
    setPlaying(false);
    moves[name]();
  };

  // ---- hands ----------------------------------------------------------------------------------------------------

  bar.addEventListener("click", (event) => {
    const button = event.target.closest("button[data-go]");
    if (button) act(button.dataset.go);
  });
  range.addEventListener("input", () => {
    setPlaying(false);
    go(scene, +range.value);
  });
  speed.addEventListener("change", () => {
    if (playing) setPlaying(true);
  });
  for (const tab of document.querySelectorAll(".scenes button"))
    tab.addEventListener("click", () => {
      setPlaying(false);
      go(+tab.dataset.scene, 0);
    });
  roomy.addEventListener("change", drawPictures);

  const dialog = find("#keys");
  find("#help").addEventListener("click", () => dialog.showModal());
  const keys = {
    ArrowLeft: "back",
    ArrowRight: "next",
    Home: "first",
    End: "last",
    PageUp: "beatback",
    PageDown: "beatnext",
    " ": "play"
  };
  document.addEventListener("keydown", (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey || dialog.open) return;
    const {target} = event;
    if (target.matches?.("input:not([type=range]), select, textarea")) return;
    if (event.key === "?") {
      event.preventDefault();
      return dialog.showModal();
    }
    if (target.matches?.(".sliders input") && event.key !== " ") return;  // they move by their own keys
    const action = event.shiftKey ? undefined : keys[event.key];
    if (!action || (event.key === " " && target.closest?.("button, summary, a"))) return;
    const room = target.closest?.(".scroll");  // a table that is wider than its place
    if (room && event.key.startsWith("Arrow") && room.scrollWidth > room.clientWidth) return;
    event.preventDefault();
    act(action);
  });

  for (const area of [find("figure.picture"), find(".told")]) {
    let from = null;
    area.addEventListener("touchstart", (event) => {
      const {clientX, clientY} = event.touches[0];
      from = event.touches.length === 1 ? [clientX, clientY] : null;
    }, {passive: true});
    area.addEventListener("touchend", (event) => {
      if (!from) return;
      const dx = event.changedTouches[0].clientX - from[0], dy = event.changedTouches[0].clientY - from[1];
      from = null;
      if (Math.abs(dx) > 40 && Math.abs(dx) > 1.5 * Math.abs(dy)) act(dx < 0 ? "next" : "back");
    }, {passive: true});
  }

  // ---- answers --------------------------------------------------------------------------------------------------

  const score = find(".score"), asked = Questions.all;
  const drawScore = () => {
    score.hidden = asked.length === 0;
    const right = asked.filter(({id}) => Questions.isRight(id)).length;
    score.querySelector("output").textContent = word("score", {n: right, all: asked.length});
    score.querySelector(".dots").replaceChildren(...asked.map(({id, scene: s, at: i}) => {
      const state = Questions.isOpen(id) ? "open" : Questions.isRight(id) ? "right" : "wrong";
      const name = word("goto", {n: lesson.scenes[s].steps[i].n});
      return element(
          "button", {
            type: "button",
            class: state,
            "aria-label": name,
            title: name,
            onclick: () => {
              setPlaying(false);
              go(s, i);
            }
          },
          {open: "?", right: "✓", wrong: "✗"}[state]);
    }));
    for (const button of score.querySelectorAll("[data-do]"))
      button.disabled = asked.every(({id}) => Questions.isOpen(id));
    drawMarks();
  };
  Questions.onChange(drawScore);
  score.addEventListener("click", (event) => {
    const action = event.target.closest("[data-do]")?.dataset.do;
    if (action === "save") score.querySelector("output").textContent = word("saved", {a: Questions.save()});
    if (action === "forget" && confirm(`${word("forget")}?`)) {
      Questions.forget();
      question.of = null;
      show();
    }
  });

  // ---- colours --------------------------------------------------------------------------------------------------

  const looks = ["auto", "light", "dark", "contrast"];
  const setLook = (look) => {
    if (look === "auto") delete root.dataset.theme;
    else root.dataset.theme = look;
    find("#theme").title = `${word("theme")}: ${word(look)}`;
  };
  const kept = (write) => {
    try {
      return write(window.localStorage);
    } catch {
      return null;
    }
  };
  const asked_for =
      new URLSearchParams(location.search).get("theme") ?? kept((store) => store.getItem("blossom/theme"));
  setLook(looks.includes(asked_for) ? asked_for : root.dataset.theme ?? "auto");
  let notice = null;
  find("#theme").addEventListener("click", () => {
    const next = looks[(looks.indexOf(root.dataset.theme ?? "auto") + 1) % looks.length];
    setLook(next);
    kept((store) => store.setItem("blossom/theme", next));
    notice?.remove();
    notice = element("p", {class: "notice", role: "status"}, `${word("theme")}: ${word(next)}`);
    document.body.append(notice);
    setTimeout((shown) => shown.remove(), 1800, notice);
  });

  // ---- paper ----------------------------------------------------------------------------------------------------

  // Each step gets its picture; the schemes go back to where they belong.
  addEventListener("beforeprint", () => {
    setPlaying(false);
    left = [...document.querySelectorAll("details")].filter((each) => !each.open);
    for (const each of left) each.open = true;
    sheet.giveBack();
    lesson.scenes.forEach(({steps: all, size}, s) => all.forEach((each, i) => {
      const svg = node("svg", {role: "img", "aria-label": word("picture", {n: each.n})});
      new Picture(svg).draw(each.s, size.s);
      items[s][i].prepend(element("figure", {class: "print"}, svg));
    }));
  });
  addEventListener("afterprint", () => {
    for (const figure of document.querySelectorAll("figure.print")) figure.remove();
    for (const each of left ?? []) each.open = false;
    show();
  });

  // ---- the beginning --------------------------------------------------------------------------------------------

  for (const each of document.querySelectorAll("details.all, details.about")) each.open = false;
  // "#7", of several scenes "#insert-7".
  const toAddress = () => {
    const parts = /^#(?:(.*)-)?(\d+)$/.exec(location.hash);
    const s = parts ? lesson.scenes.findIndex(({id}) => id === (parts[1] ?? "")) : 0;
    const i = parts && s >= 0 ? lesson.scenes[s].steps.findIndex(({n}) => n === +parts[2]) : 0;
    go(Math.max(s, 0), Math.max(i, 0));
  };
  addEventListener("hashchange", toAddress);
  toAddress();
  drawScore();
})();
