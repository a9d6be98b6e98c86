// Joins each estimate with the truth of its time. Truth and estimates have times of their own, so the truth is taken between its two
// neighbours. Pure: no page, no clock.
const patience = 2, longestGap = 0.5, anotherRun = 5, kept = 500; // s, s, s, truths

export class Truths {
  // between(a, b, share): the message at a share of the way from one message to the next.
  constructor(between) { Object.assign(this, { between }).forget(); }
  forget() { Object.assign(this, { truths: [], waiting: [], first: undefined, last: -Infinity }); }
  get newest() { return this.truths.length ? this.truths[this.truths.length - 1].t : -Infinity; }

  takeTruth(t, message) {
    if (t < this.newest - anotherRun) this.forget();
    let at = this.truths.length;
    while (at > 0 && this.truths[at - 1].t > t) --at;
    this.truths.splice(at, 0, { t, message });
    if (this.truths.length > kept) this.truths.shift();
    this.settle();
  }
  // Calls show(truth, alone) as soon as the truth of the time t is known. Truth undefined: it has a hole there. Alone: there is none at all.
  takeEstimate(t, show) {
    if (t < this.last - anotherRun) this.forget();
    this.first ??= t;
    this.last = Math.max(this.last, t);
    this.waiting.push({ t, show });
    this.settle();
  }
  settle() {
    const alone = this.last - Math.max(this.newest, this.first ?? Infinity) > patience;
    const { waiting, newest } = this;
    this.waiting = alone ? [] : waiting.filter(({ t }) => t > newest);
    for (const { t, show } of waiting) if (alone || t <= newest) show(this.at(t), alone);
  }
  at(t) {
    const after = this.truths.findIndex((one) => one.t >= t), [b, a] = [this.truths[after], this.truths[after - 1]];
    if (!b || b.t === t) return b?.message;
    return a && b.t - a.t <= longestGap ? this.between(a.message, b.message, (t - a.t) / (b.t - a.t)) : undefined;
  }
}
