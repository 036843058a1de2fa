"use strict";
// The questions of a lesson. Their words stand in the document, beside the step they belong to; what is right, in the
// lesson's data. Answers are kept in the browser's own store, where it has one, and saved as a file.
const Questions = (() => {
  const lesson = JSON.parse(document.getElementById("lesson").textContent);
  const word = (key, values = {}) => lesson.words[key].replace(/\{(\w+)\}/g, (all, name) => values[name] ?? all);
  const STORE = `blossom/answers/${lesson.id}`;

  const element = (name, attributes = {}, ...children) => {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
      if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
      else if (value !== false) made.setAttribute(key, value === true ? "" : value);
    made.append(...children);
    return made;
  };
  const copies = (node) => [...(node.content ?? node).childNodes].map((each) => each.cloneNode(true));

  const all = lesson.scenes.flatMap(
      (scene, s) => scene.steps.flatMap((step, i) => (step.q ? [{...step.q, scene: s, at: i}] : [])));
  const given = new Map();  // by id: { answer, right, shown }: whether the page has told what is right
  const store = (write) => {
    try {
      return write(window.localStorage);
    } catch {
      return null;
    }
  };
  try {
    const kept = JSON.parse(store((storage) => storage.getItem(STORE)) ?? "{}");
    for (const {id} of all)
      if (kept[id] && "answer" in kept[id])
        given.set(id, {answer: kept[id].answer, right: !!kept[id].right, shown: !!kept[id].shown});
  } catch {
    given.clear();
  }

  const listeners = [];
  const changed = () => {
    store(
        (storage) => given.size > 0 ? storage.setItem(STORE, JSON.stringify(Object.fromEntries(given))) :
                                      storage.removeItem(STORE));
    for (const each of listeners) each();
  };

  // A number as it is typed: 2, -0.4, 0,4, 2/5, -3/2; anything else is nothing, as it is for who grades the file.
  const tidy = (text) => text.trim().replace(/[\u2212\u2013]/g, "-").replace(/\s+/g, "").replace(",", ".");
  const number = (text) => {
    const typed = tidy(text), parts = /^([+-]?\d+)\/(\d+)$/.exec(typed);
    if (parts) return +parts[2] === 0 ? null : +parts[1] / +parts[2];
    return /^[+-]?(?:\d+\.?\d*|\.\d+)$/.test(typed) ? +typed : null;
  };
  // As answers files have it: whole numbers as numbers, all others exactly as typed.
  const written = (text) => (/^[+-]?\d{1,15}$/.test(tidy(text)) ? +tidy(text) : tidy(text).replace(/^\+/, ""));

  const near = (value, right, decimals) =>
      right !== null && Math.abs(value - right) <= 0.5 * 10 ** -decimals * (1 + 1e-9);

  // One question as it is asked beside its step.
  class Asked {
    constructor(question, item, code) {
      this.question = question;
      this.ask = item.querySelector(".ask");
      this.code = code;
      this.feedback = element("div", {class: "feedback", role: "status"});
      this.form = element("form", {
        onsubmit: (event) => {
          event.preventDefault();
          this.check();
        }
      });
      this.root = element(
          "section", {class: "card asked", "aria-labelledby": "asked-head"},
          element("h2", {id: "asked-head"}, word("question")),
          element("div", {class: "words"}, ...copies(this.ask.querySelector(".words"))), this.form, this.feedback);
      this[question.kind]();
      const before = given.get(question.id);
      // What was kept may be of an older lesson, whose question was another one.
      try {
        if (before) {
          this.fill(before.answer);
          this.tell(before.right, before.answer);
        }
      } catch {
        given.delete(question.id);
      }
    }

    options() { return [...this.ask.querySelectorAll("li.option")]; }
    // What stands in a template of the question; its words once more where there is none.
    said(name, place = 0) {
      return copies(this.ask.querySelectorAll(`template.${name}`)[place]).filter((node) => node.textContent.trim());
    }

    answer(answer, right) {
      given.set(this.question.id, {answer, right, shown: !!given.get(this.question.id)?.shown});
      changed();
      this.tell(right, answer);
      this.feedback.scrollIntoView({block: "nearest"});
    }

    tell(right, answer) {
      const place = this.question.kind === "choice" ? answer.charCodeAt(0) - 97 : -1;
      let words = place >= 0 && place < this.options().length ? this.said("feedback", place) : [];
      if (words.length === 0) words = this.said(right ? "right" : "wrong");
      else if (right) words.push(...this.said("right"));
      this.feedback.className = `feedback ${right ? "right" : "wrong"}`;
      this.feedback.replaceChildren(element("p", {class: "verdict"}, word(right ? "right" : "wrong")), ...words);
      if (!right)
        this.feedback.append(
            element("button", {type: "button", "data-do": "show", onclick: () => this.show()}, word("show")));
      this.marked?.(right, answer);
    }

    complain(text) {
      this.feedback.className = "feedback open";
      this.feedback.replaceChildren(element("p", {}, text));
    }

    show() {
      const {id, kind, answer} = this.question;
      given.set(id, {...given.get(id), shown: true});
      changed();
      this.complain(word("answer", {a: answer}));
      if (kind === "choice") this.feedback.append(...this.said("feedback", answer.charCodeAt(0) - 97));
      this.reveal?.(answer);
    }

    // ---- choice and line: a button each --------------------------------------------------------------------------

    buttons(labels, answers, style) {
      this.list = element(
          "ol", {class: `picks ${style}`},
          ...labels.map(
              (label, i) => element(
                  "li", {},
                  element(
                      "button", {
                        type: "button",
                        "data-answer": answers[i],
                        "aria-pressed": "false",
                        onclick: () => this.answer(answers[i], String(answers[i]) === this.question.answer)
                      },
                      ...label))));
      this.form.append(this.list);
      const mark = (answer, name) => {
        for (const button of this.list.querySelectorAll("button")) {
          const own = button.dataset.answer === String(answer);
          button.classList.toggle("right", own && name === "right");
          button.classList.toggle("wrong", own && name === "wrong");
          button.setAttribute("aria-pressed", own);
        }
      };
      this.marked = (right, answer) => mark(answer, right ? "right" : "wrong");
      this.fill = () => {};
      // Beside what was picked, which stays as it is.
      this.reveal = (answer) => this.list.querySelector(`[data-answer="${answer}"]`)?.classList.add("right");
    }

    choice() {
      const options = this.options();
      this.buttons(
          options.map((option, i) => [element("b", {}, "abcdefgh"[i]), element("span", {}, ...copies(option))]),
          options.map((_, i) => "abcdefgh"[i]), "choices");
    }

    line() {
      const lines = [...this.code.querySelectorAll("li")];
      this.buttons(
          lines.map((line, i) => [element("b", {}, String(i + 1)), ...copies(line)]), lines.map((_, i) => i + 1),
          "lines");
    }

    // ---- predict and span: numbers -------------------------------------------------------------------------------

    fields(names) {
      this.inputs = names.map(([visible, spoken]) => element("input", {
                                type: "text",
                                autocomplete: "off",
                                autocapitalize: "off",
                                spellcheck: "false",
                                "aria-label": spoken,
                                size: names.length === 1 ? 12 : 7,
                                "data-name": visible
                              }));
      this.form.append(element(
          "div", {class: "fields"},
          ...this.inputs.map((input) => {
            const {name} = input.dataset;
            return element("label", {}, ...(name ? [element("i", {}, name)] : []), input);
          }),
          element("button", {class: "main"}, word("check"))));
      this.fill = (answer) => {
        const texts = Array.isArray(answer) ? answer : [answer];
        if (this.inputs.length === 1) this.inputs[0].value = texts.join("; ");
        else
          this.inputs.forEach((input, i) => {
            input.value = texts[i] ?? "";
          });
      };
    }

    predict() {
      const {numbers, fields, decimals, whole} = this.question;
      this.fields(
          fields > 1 ? ["x", "y", "z", "w"].slice(0, fields).map((name) => [name, word("coordinate", {a: name})]) :
                       [["", word("value")]]);
      this.form.append(element("p", {class: "quiet"}, decimals > 0 ? word("decimals", {n: decimals}) : word("wholes")));
      this.check = () => {
        let texts = this.inputs.map((input) => input.value);
        // Several numbers in one field; a comma is a decimal point only where there are semicolons.
        if (texts.length === 1 && numbers.length > 1) {
          texts = texts[0].replace(/[()[\]]/g, "").split(texts[0].includes(";") ? ";" : ",");
          if (texts.length !== numbers.length) return this.complain(word("count", {n: numbers.length}));
        }
        const values = texts.map(number);
        this.inputs.forEach(
            (input, i) => input.toggleAttribute("aria-invalid", this.inputs.length > 1 && values[i] === null));
        if (values.includes(null)) return this.complain(word(this.inputs.length > 1 ? "unreadfield" : "unread"));
        const answer = texts.map(written);
        this.answer(
            answer.length === 1 ? answer[0] : answer,
            values.every((value, i) => (whole ? value === numbers[i] : near(value, numbers[i], decimals))));
      };
    }

    span() {
      this.fields([["k", word("index")]]);
      const right = this.question.numbers[0];
      const take = (k) => this.answer(k, k === right);
      this.check = () => {
        const k = number(this.inputs[0].value);
        if (k === null || !Number.isInteger(k)) return this.complain(word("unread"));
        take(k);
      };
      const spans = this.question.spans ?? [];
      if (spans.length === 0) return;
      this.form.append(
          element("p", {class: "quiet"}, word("pick")),
          element(
              "div", {class: "spans"},
              ...spans.map(
                  ([k, text]) => element(
                      "button", {
                        type: "button",
                        "data-answer": k,
                        onclick: () => {
                          this.inputs[0].value = k;
                          take(k);
                        }
                      },
                      text))));
      this.marked = (isRight, answer) => {
        for (const button of this.form.querySelectorAll(".spans button")) {
          button.classList.toggle("right", isRight && +button.dataset.answer === answer);
          button.classList.toggle("wrong", !isRight && +button.dataset.answer === answer);
        }
      };
    }

    // ---- order: by dragging, or with buttons ---------------------------------------------------------------------

    order() {
      this.list = element(
          "ol", {class: "picks order"}, ...this.options().map((option, i) => this.movable(option, "abcdefgh"[i])));
      this.form.append(
          element("p", {class: "quiet"}, word("orderhint")), this.list,
          element("button", {class: "main"}, word("check")));
      const letters = () => [...this.list.children].map((item) => item.dataset.letter).join("");
      this.fill = (answer) => {
        const text = Array.isArray(answer) ? answer.join("") : String(answer);
        for (const letter of text) {
          const item = [...this.list.children].find((each) => each.dataset.letter === letter);
          if (item) this.list.append(item);
        }
      };
      this.check = () => this.answer(letters(), letters() === this.question.answer);
      this.reveal = (answer) => this.fill(answer);
    }

    movable(option, letter) {
      const name = option.textContent.trim();
      const move = (item, by) => {
        const other = by < 0 ? item.previousElementSibling : item.nextElementSibling;
        if (other) by < 0 ? other.before(item) : other.after(item);
      };
      const arrow = (by, key, sign) => element(
          "button", {
            type: "button",
            class: "arrow",
            "aria-label": word(key, {a: name}),
            onclick: (event) => {
              move(item, by);
              event.currentTarget.focus();
            }
          },
          sign);
      const item = element(
          "li", {"data-letter": letter}, element("span", {class: "text"}, ...copies(option)), arrow(-1, "up", "▲"),
          arrow(1, "down", "▼"));
      let held = null;
      item.addEventListener("pointerdown", (event) => {
        if (event.target.closest("button")) return;
        held = event.pointerId;
        item.setPointerCapture(held);
        item.classList.add("held");
      });
      item.addEventListener("pointermove", (event) => {
        if (held !== event.pointerId) return;
        const above = item.previousElementSibling?.getBoundingClientRect(),
              below = item.nextElementSibling?.getBoundingClientRect();
        if (above && event.clientY < above.top + above.height / 2) move(item, -1);
        else if (below && event.clientY > below.top + below.height / 2) move(item, 1);
      });
      for (const end of ["pointerup", "pointercancel"])
        item.addEventListener(end, () => {
          held = null;
          item.classList.remove("held");
        });
      return item;
    }
  }

  const file = () => JSON.stringify(
                         {
                           schema: "blossom.answers/1",
                           exercise: lesson.id,
                           answers: Object.fromEntries([...given].map(([id, {answer}]) => [id, answer]))
                         },
                         null, 2) +
      "\n";

  return {
    all,
    lesson,
    word,
    element,
    copies,
    isRight: (id) => given.get(id)?.right && !given.get(id).shown,
    isOpen: (id) => !given.has(id),
    show: (question, item, code) => new Asked(question, item, code).root,
    forget() {
      given.clear();
      changed();
    },
    onChange(listener) { listeners.push(listener); },
    save() {
      const name = `${lesson.id}-answers.json`;
      const address = URL.createObjectURL(new Blob([file()], {type: "application/json"}));
      element("a", {href: address, download: name}).click();
      setTimeout(() => URL.revokeObjectURL(address), 10000);
      return name;
    },
  };
})();
