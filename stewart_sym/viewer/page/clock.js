// The clock: time of the displayed sample. It runs at a speed and restarts at the end.

export class Clock {
  constructor(motion) {
    this.motion = motion;
    this.time = motion.start;
    this.index = 0;
    this.speed = 1;
    this.playing = false;
    this.listeners = [];
    const steps = Math.max(1, motion.count - 1);
    this.decimals = Math.max(1, Math.min(6, Math.ceil(-Math.log10(motion.duration / steps / 2 || 1))));
  }

  // `listener` is called with the index of the sample when it changes, or when the clock starts or stops.
  onChange(listener) {
    this.listeners.push(listener);
  }

  tell() {
    for (const listener of this.listeners) listener(this.index);
  }

  // Returns the sample nearest to a time (s).
  seek(time) {
    const { motion } = this;
    this.time = Math.max(motion.start, Math.min(motion.start + motion.duration, time));
    this.index = motion.nearest(this.time);
    this.tell();
  }

  // Moves by a number of samples.
  step(count) {
    const index = Math.max(0, Math.min(this.motion.count - 1, this.index + count));
    this.pause();
    this.seek(this.motion.time[index]);
  }

  play() {
    if (this.motion.duration > 0) this.playing = true;
    if (this.time >= this.motion.start + this.motion.duration) this.time = this.motion.start;
    this.tell();
  }

  pause() {
    this.playing = false;
    this.tell();
  }

  // Advances the time by a number of seconds.
  pass(seconds) {
    const { start, duration } = this.motion;
    const since = this.time - start + seconds * this.speed;
    this.seek(start + (since > duration ? since % duration : since));
  }

  text(time = this.motion.time[this.index]) {
    return `${time.toFixed(this.decimals).replace("-", "\u2212")} s`;
  }
}
