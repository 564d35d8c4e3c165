// SPDX-License-Identifier: Apache-2.0
// Whether a headset can be entered from here, why not, and entering it.

export interface VrAnswer {
  readonly vr: "yes" | "no" | "unknown";
  /** Why, or what to do. */
  readonly hint: string;
}

export async function askForVr(): Promise<VrAnswer> {
  if (!window.isSecureContext) {
    return {
      vr: "no",
      hint: "Browsers allow headsets only on https or on this machine itself: open the https address that feelem printed.",
    };
  }
  if (!navigator.xr)
    return { vr: "no", hint: "This browser has no WebXR: open the page in the browser of the headset." };
  try {
    const yes = await navigator.xr.isSessionSupported("immersive-vr");
    return yes
      ? { vr: "yes", hint: "see, hear and feel the model in the headset" }
      : { vr: "no", hint: "No headset is connected to this browser." };
  } catch (error) {
    return {
      vr: "no",
      hint: `The headset cannot be used: ${error instanceof Error ? error.message : String(error)}`,
    };
  }
}

export async function requestVr(): Promise<XRSession> {
  if (!navigator.xr) throw new Error("this browser has no WebXR");
  // Safari's headsets ask the person whether hands may be tracked, though their pinches come without.
  const asks = /Version\/\S+ Safari/.test(navigator.userAgent);
  return navigator.xr.requestSession("immersive-vr", {
    requiredFeatures: ["local-floor"],
    optionalFeatures: asks ? [] : ["hand-tracking"],
  });
}
