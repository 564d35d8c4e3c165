// SPDX-License-Identifier: Apache-2.0
// Every way to leave ends sound and touch.
import { afterEach, expect, test, vi } from "vitest";
import { stopWhenLeft } from "../../src/sense";

/** A page and a session that can be left. */
function rig() {
  const page = Object.assign(new EventTarget(), { visibilityState: "visible" });
  const frame = new EventTarget();
  const session = Object.assign(new EventTarget(), { visibilityState: "visible" });
  vi.stubGlobal("document", page);
  vi.stubGlobal("window", frame);
  return { page, frame, session };
}
afterEach(() => vi.unstubAllGlobals());

test("A10 blur, a hidden page and its end stop at the desk", () => {
  const { page, frame } = rig();
  const stop = vi.fn();
  const end = stopWhenLeft(stop);
  page.dispatchEvent(new Event("visibilitychange"));
  expect(stop).not.toHaveBeenCalled();
  frame.dispatchEvent(new Event("blur"));
  expect(stop).toHaveBeenCalledTimes(1);
  page.visibilityState = "hidden";
  page.dispatchEvent(new Event("visibilitychange"));
  expect(stop).toHaveBeenCalledTimes(2);
  frame.dispatchEvent(new Event("pagehide"));
  expect(stop).toHaveBeenCalledTimes(3);
  end();
  frame.dispatchEvent(new Event("blur"));
  expect(stop).toHaveBeenCalledTimes(3);
});

test("A10 the session's menu and its end stop in the headset", () => {
  const { frame, session } = rig();
  const stop = vi.fn();
  stopWhenLeft(stop, session as unknown as XRSession);
  session.dispatchEvent(new Event("visibilitychange"));
  frame.dispatchEvent(new Event("blur"));
  expect(stop).not.toHaveBeenCalled();
  session.visibilityState = "visible-blurred";
  session.dispatchEvent(new Event("visibilitychange"));
  expect(stop).toHaveBeenCalledTimes(1);
  session.dispatchEvent(new Event("end"));
  expect(stop).toHaveBeenCalledTimes(2);
});
