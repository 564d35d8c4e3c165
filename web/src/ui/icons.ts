// SPDX-License-Identifier: Apache-2.0
// Line icons, 20 by 20, in the colour of the text.
import { html, svg, type TemplateResult } from "lit";

const PATHS = {
  eye: svg`<path d="M2 10s3-5 8-5 8 5 8 5-3 5-8 5-8-5-8-5Z"/><circle cx="10" cy="10" r="2.4"/>`,
  ear: svg`<path d="M6.5 8a4 4 0 1 1 7 2.6c-1.2 1.3-1.7 1.8-1.7 3.2a2.3 2.3 0 0 1-4.3 1M8.6 8a1.8 1.8 0 1 1 3 1.5"/>`,
  ticks: svg`<path d="M3 7v6M7 4.5v11M11 7v6M15 4.5v11"/>`,
  hand: svg`<path d="M6 10V5.2a1.2 1.2 0 0 1 2.4 0V9M8.4 9V3.7a1.2 1.2 0 0 1 2.4 0V9M10.8 9V4.6a1.2 1.2 0 0 1 2.4 0V12c0 3-1.8 5-4.4 5-2 0-3.2-1-4.2-2.8L3 11.4a1.2 1.2 0 0 1 2-1.2l1 1.2"/>`,
  shape: svg`<path d="M3 15c3.5 0 4-9 7-9s3.500 5 7 5M3 15h14" />`,
  off: svg`<circle cx="10" cy="10" r="6"/><path d="M5.800 14.200 14.200 5.800"/>`,
  play: svg`<path d="M6.500 4.500v11l9-5.500Z" fill="currentColor"/>`,
  pause: svg`<path d="M6.500 4.500v11M13.500 4.500v11" stroke-width="2.600"/>`,
  back: svg`<path d="m12 5-5 5 5 5"/>`,
  next: svg`<path d="m8 5 5 5-5 5"/>`,
  fit: svg`<path d="M3 7V3h4M17 7V3h-4M3 13v4h4M17 13v4h-4"/>`,
  mesh: svg`<path d="M3 3h14v14H3ZM3 10h14M10 3v14"/>`,
  lamp: svg`<path d="M7.500 14a4.800 4.800 0 1 1 5 0v1.500h-5ZM8.500 18h3"/>`,
  pins: svg`<path d="M10 17s5-4.600 5-8.500a5 5 0 0 0-10 0C5 12.400 10 17 10 17Z"/><circle cx="10" cy="8.500" r="1.700"/>`,
  theme: svg`<circle cx="10" cy="10" r="6.500"/><path d="M10 3.500v13a6.500 6.500 0 0 0 0-13Z" fill="currentColor"/>`,
  sound: svg`<path d="M3 8v4h3l4 3.500v-11L6 8ZM13 7.500a3.500 3.500 0 0 1 0 5M15 5a7 7 0 0 1 0 10"/>`,
  mute: svg`<path d="M3 8v4h3l4 3.500v-11L6 8ZM13 8l4 4M17 8l-4 4"/>`,
  headset: svg`<path d="M3 7.500h14v6h-4l-1.500-2h-3L7 13.500H3ZM6 7.500V5.500h8v2"/>`,
  search: svg`<circle cx="9" cy="9" r="5"/><path d="m13 13 4 4"/>`,
  prompt: svg`<path d="m4 6 4 4-4 4M10 14h6"/>`,
  close: svg`<path d="m5 5 10 10M15 5 5 15"/>`,
  list: svg`<path d="M3 5h14M3 10h14M3 15h14"/>`,
  plus: svg`<path d="M10 4v12M4 10h12"/>`,
  glass: svg`<path d="M4 4h12v12H4ZM4 12l8-8M4 16 16 4M8 16l8-8"/>`,
  target: svg`<circle cx="10" cy="10" r="6"/><circle cx="10" cy="10" r="1.500" fill="currentColor"/><path d="M10 2v3M10 15v3M2 10h3M15 10h3"/>`,
  cut: svg`<path d="M4 7l6-3 6 3v6l-6 3-6-3ZM2 15 18 5"/>`,
  keys: svg`<path d="M2.500 5.500h15v9h-15ZM5.500 8.500h0M8.500 8.500h0M11.500 8.500h0M14.500 8.500h0M6.500 11.500h7" stroke-linecap="round"/>`,
} as const;

export type IconName = keyof typeof PATHS;

export function icon(name: IconName): TemplateResult {
  return html`<svg class="icon" viewBox="0 0 20 20" aria-hidden="true" fill="none" stroke="currentColor" stroke-width="1.500" stroke-linejoin="round" stroke-linecap="round">${PATHS[name]}</svg>`;
}
