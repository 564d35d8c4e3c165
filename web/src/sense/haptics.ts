// SPDX-License-Identifier: Apache-2.0
// The vibration engine: pulses in the hand whose rate and strength say the value. One call a beat, because calls of
// the browsers' interfaces override each other. Time is handed in, so that tests need no clock.

/** Something that can shake. */
export interface Actuator {
  /** Strength 0..1 for some milliseconds. */
  pulse(strength: number, milliseconds: number): void;
}

/** What is to be felt now. */
export interface HapticFrame {
  /** Pulses a second (Pulse.rate); 0: none. */
  readonly rate: number;
  /** 0..1 (Pulse.amplitude). */
  readonly amplitude: number;
  /** Length of a pulse. */
  readonly milliseconds?: number;
  /** Beyond the limit: a quarter faster, up to 10 Hz. */
  readonly alarm?: boolean;
  /** Neither place nor value has changed to speak of: after 1.5 s one soft pulse a second. */
  readonly still?: boolean;
}

export type HapticEvent = "limitUp" | "limitDown" | "maximum" | "minimum" | "enter" | "band";

export interface SentPulse {
  /** Seconds. */
  readonly time: number;
  readonly strength: number;
  readonly milliseconds: number;
  /** "beat" or the event that it belongs to. */
  readonly cause: "beat" | HapticEvent;
}

export interface Haptics {
  /** What the next ticks send; null: nothing. */
  update(frame: HapticFrame | null): void;
  /** Once a frame, in seconds of any clock that never goes back. Sends at most one pulse. */
  tick(now: number): void;
  /** Queues an event; those of the limit push aside everything else for 250 ms. */
  event(kind: HapticEvent): void;
  /** Nothing more: release, blur, end of the session. */
  stop(): void;
  /** Who shakes; null: nobody, and the caller lets the ear take over. */
  setActuator(actuator: Actuator | null): void;
  readonly hasActuator: boolean;
  /** The person's own strength, 0..1.5. */
  setStrength(strength: number): void;
  /** The last thousand pulses sent. */
  pulses(): readonly SentPulse[];
}

const shortestGap = 0.08;
const longestPulse = 200;
const largestDuty = 0.45;
const fastestAlarm = 10;
const stillAfter = 1.5;
const limitHolds = 0.25;
const keptPulses = 1000;

interface QueuedPulse {
  /** After the first of its event. */
  readonly delay: number;
  readonly strength: number;
  readonly milliseconds: number;
}
const eventPulses: Readonly<Record<HapticEvent, readonly QueuedPulse[]>> = {
  limitUp: [
    { delay: 0, strength: 1, milliseconds: 60 },
    { delay: 0.12, strength: 1, milliseconds: 60 },
  ],
  limitDown: [{ delay: 0, strength: 0.4, milliseconds: 40 }],
  maximum: [{ delay: 0, strength: 0.8, milliseconds: 80 }],
  minimum: [{ delay: 0, strength: 0.3, milliseconds: 80 }],
  band: [{ delay: 0, strength: 0.35, milliseconds: 20 }],
  enter: [{ delay: 0, strength: 0.2, milliseconds: 15 }],
};

class Pulser implements Haptics {
  #actuator: Actuator | null = null;
  #frame: HapticFrame | null = null;
  #strength = 1;
  #now = Number.NEGATIVE_INFINITY;
  #last = Number.NEGATIVE_INFINITY;
  #next = Number.NEGATIVE_INFINITY;
  /** Before this nothing but the limit may speak: it would cut a pulse short or leave the hand no rest. */
  #busyUntil = Number.NEGATIVE_INFINITY;
  #period = 0;
  #stillSince = Number.POSITIVE_INFINITY;
  #heldUntil = Number.NEGATIVE_INFINITY;
  #event: { kind: HapticEvent; start: number; sent: number } | null = null;
  readonly #sent: SentPulse[] = [];

  get hasActuator(): boolean {
    return this.#actuator !== null;
  }
  setActuator(actuator: Actuator | null): void {
    this.#actuator = actuator;
  }
  setStrength(strength: number): void {
    this.#strength = Math.min(Math.max(strength, 0), 1.5);
  }
  pulses(): readonly SentPulse[] {
    return this.#sent;
  }

  update(frame: HapticFrame | null): void {
    if (!frame || !(frame.rate > 0)) {
      this.#frame = null;
      this.#period = 0;
      this.#stillSince = Number.POSITIVE_INFINITY;
      return;
    }
    this.#frame = frame;
    if (!frame.still) this.#stillSince = Number.POSITIVE_INFINITY;
  }

  event(kind: HapticEvent): void {
    const isLimit = kind === "limitUp" || kind === "limitDown";
    const running = this.#event?.kind;
    if (!isLimit && (running !== undefined || this.#now < this.#heldUntil)) return;
    this.#event = { kind, start: Number.NaN, sent: 0 };
  }

  stop(): void {
    this.update(null);
    this.#event = null;
    this.#heldUntil = Number.NEGATIVE_INFINITY;
  }

  tick(now: number): void {
    this.#now = now;
    if (this.#tickEvent(now) || now < this.#heldUntil) return;
    const frame = this.#frame;
    if (!frame) return;
    const { period, share } = this.#beat(frame, now);
    if (period !== this.#period) {
      // A new rate counts from the last pulse: it is felt within a frame.
      this.#next = this.#period === 0 ? now : Math.min(this.#next, this.#last + period);
      this.#period = period;
    }
    if (now < this.#next || now < this.#busyUntil) return;
    const longest = Math.min(longestPulse, 1000 * largestDuty * Math.max(period, shortestGap));
    this.#send(now, frame.amplitude * share, Math.min(frame.milliseconds ?? 35, longest), "beat");
    // Adding the period to the planned time, not to this frame's, keeps the rate right on average.
    this.#next += period;
    if (this.#next < now) this.#next = now + period;
  }

  #beat(frame: HapticFrame, now: number): { period: number; share: number } {
    if (frame.still) this.#stillSince = Math.min(this.#stillSince, now);
    if (now - this.#stillSince >= stillAfter) return { period: 1, share: 0.5 };
    const rate = frame.alarm ? Math.max(frame.rate, Math.min(1.25 * frame.rate, fastestAlarm)) : frame.rate;
    return { period: 1 / rate, share: 1 };
  }

  #tickEvent(now: number): boolean {
    const event = this.#event;
    if (!event) return false;
    const isLimit = event.kind === "limitUp" || event.kind === "limitDown";
    if (Number.isNaN(event.start)) {
      if (!isLimit && now < this.#busyUntil) return false;
      event.start = now;
      if (isLimit) this.#heldUntil = now + limitHolds;
    }
    const pulse = eventPulses[event.kind][event.sent];
    if (!pulse) {
      this.#event = null;
      return false;
    }
    if (now < event.start + pulse.delay) return true;
    this.#send(now, pulse.strength, pulse.milliseconds, event.kind);
    event.sent++;
    if (event.sent === eventPulses[event.kind].length) this.#event = null;
    return true;
  }

  #send(now: number, strength: number, milliseconds: number, cause: SentPulse["cause"]): void {
    this.#last = now;
    this.#busyUntil = now + Math.max(shortestGap, milliseconds / 1000 / largestDuty);
    const felt = Math.min(strength * this.#strength, 1);
    if (!this.#actuator || !(felt > 0)) return;
    this.#actuator.pulse(felt, milliseconds);
    this.#sent.push({ time: now, strength: felt, milliseconds, cause });
    if (this.#sent.length > keptPulses) this.#sent.shift();
  }
}

export function createHaptics(): Haptics {
  return new Pulser();
}

/** The older interface, which the types of the browser do not know. */
interface PulseActuator {
  pulse?(value: number, duration: number): Promise<unknown>;
}

const ignoreRefusal = (promise: Promise<unknown> | undefined) => {
  promise?.catch(() => undefined);
};

/** What of a gamepad can shake: hapticActuators[0].pulse, else vibrationActuator.playEffect, else null. */
export function actuatorOf(gamepad: Gamepad | null | undefined): Actuator | null {
  if (!gamepad) return null;
  const first = (gamepad as { hapticActuators?: readonly PulseActuator[] }).hapticActuators?.[0];
  if (first?.pulse) return { pulse: (strength, ms) => ignoreRefusal(first.pulse?.(strength, ms)) };
  const motor = gamepad.vibrationActuator as GamepadHapticActuator | null | undefined;
  if (!motor?.playEffect) return null;
  return {
    pulse: (strength, duration) =>
      ignoreRefusal(
        motor.playEffect("dual-rumble", { duration, strongMagnitude: strength, weakMagnitude: strength }),
      ),
  };
}

/** Phones and tablets with Android shake as a whole; other browsers that know the call have nothing to shake. */
export function actuatorOfDevice(
  device: Pick<Navigator, "userAgent" | "vibrate" | "userActivation">,
): Actuator | null {
  if (!/Android/.test(device.userAgent) || typeof device.vibrate !== "function") return null;
  // Before the first tap it would be refused, and nothing would stand in.
  if (device.userActivation && !device.userActivation.hasBeenActive) return null;
  return { pulse: (_strength, milliseconds) => void device.vibrate(milliseconds) };
}
