// SPDX-License-Identifier: Apache-2.0
// Silence and stillness when nobody is there: hidden page, lost focus, end or menu of a headset session.

/** Calls `stop` whenever the person leaves; returns what ends the watching. */
export function stopWhenLeft(stop: () => void, session?: XRSession | null): () => void {
  const whenHidden = () => {
    if (document.visibilityState !== "visible") stop();
  };
  const whenUnfocused = () => {
    if (session?.visibilityState !== "visible") stop();
  };
  document.addEventListener("visibilitychange", whenHidden);
  window.addEventListener("pagehide", stop);
  // In a headset the page itself may lose the focus while the session has it.
  if (!session) window.addEventListener("blur", stop);
  session?.addEventListener("visibilitychange", whenUnfocused);
  session?.addEventListener("end", stop);
  return () => {
    document.removeEventListener("visibilitychange", whenHidden);
    window.removeEventListener("pagehide", stop);
    window.removeEventListener("blur", stop);
    session?.removeEventListener("visibilitychange", whenUnfocused);
    session?.removeEventListener("end", stop);
  };
}
