// SPDX-License-Identifier: Apache-2.0
// Keys of the page. One table serves the handler and the help.

export interface KeyCommand {
  readonly keys: readonly string[];
  readonly text: string;
  readonly shown: string;
  readonly down: (key: string) => void;
  readonly up?: () => void;
  /** Whether the key means this now; without it: always. The first that does counts. */
  readonly when?: (event: KeyboardEvent) => boolean;
}

const TYPING = "input:not([type=range]):not([type=checkbox]), select, textarea";

/** Keys typed into a field stay there. Returns its own removal. */
export function attachKeyboard(commands: readonly KeyCommand[]): () => void {
  const held = new Map<string, KeyCommand>();
  const find = (key: string, event: KeyboardEvent) =>
    commands.find(
      (c) => c.keys.includes(key.length === 1 ? key.toLowerCase() : key) && (c.when?.(event) ?? true),
    );
  const chord = (event: KeyboardEvent) => `ctrl+${event.shiftKey ? "shift+" : ""}${event.key.toLowerCase()}`;
  const down = (event: KeyboardEvent) => {
    if (event.altKey) return;
    const target = event.target instanceof Element ? event.target : null;
    const isPalette = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "k";
    if (target?.matches(TYPING) && !isPalette) return;
    if (event.key.startsWith("Arrow") && target?.matches("input, summary")) return;
    if (event.key === " " && target?.closest("button, summary, input, [role=button]")) return;
    // In a column these keys leaf through it.
    if (event.key.startsWith("Page") && target?.closest(".area-left, .area-right")) return;
    const withControl = event.ctrlKey || event.metaKey;
    const named = event.shiftKey && event.key.startsWith("Arrow") ? `shift+${event.key}` : event.key;
    const command = withControl ? commands.find((c) => c.keys.includes(chord(event))) : find(named, event);
    if (!command || target?.closest("dialog")) return;
    event.preventDefault();
    if (event.repeat && command.up) return;
    if (command.up) held.set(event.key.toLowerCase(), command);
    command.down(event.key);
  };
  const up = (event: KeyboardEvent) => {
    const key = event.key.toLowerCase();
    held.get(key)?.up?.();
    held.delete(key);
  };
  const blur = () => {
    for (const command of held.values()) command.up?.();
    held.clear();
  };
  window.addEventListener("keydown", down);
  window.addEventListener("keyup", up);
  window.addEventListener("blur", blur);
  return () => {
    window.removeEventListener("keydown", down);
    window.removeEventListener("keyup", up);
    window.removeEventListener("blur", blur);
  };
}
