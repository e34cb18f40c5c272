// The look of the player, within its shadow. A sheet that is constructed needs no inline style, which
// a strict content security policy refuses.
export const playerStyle = new CSSStyleSheet();
playerStyle.replaceSync(`
:host {
  --ink: #f4f5f7;
  --ground: rgb(20 22 26 / 0.82);
  --line: #8b929e;
  --focus: #ffd166;
  display: block;
  position: relative;
  width: 100%;
  aspect-ratio: 4 / 3;
  overflow: hidden;
  background: #17191d;
  color: var(--ink);
  font: 16px/1.4 system-ui, sans-serif;
}
:host([hidden]) { display: none; }
:host(:fullscreen) { width: 100vw; height: 100vh; aspect-ratio: auto; }
canvas {
  position: absolute;
  inset: 0;
  width: 100%;
  height: 100%;
  touch-action: none;
  cursor: grab;
}
canvas:active { cursor: grabbing; }
:focus-visible { outline: 3px solid var(--focus); outline-offset: -3px; }
canvas:focus-visible { outline-color: #ffd166; }  /* seen on the grey behind the face, dark or light */
button:focus-visible, select:focus-visible { outline-offset: 2px; }
.head {
  position: absolute;
  inset-inline: 0;
  top: max(0.75rem, env(safe-area-inset-top));
  pointer-events: none;
}
.message {
  width: fit-content;
  max-width: calc(100% - 2rem);
  box-sizing: border-box;
  margin: 0 auto;
  padding: 0.35rem 0.9rem;
  border-radius: 1rem;
  background: var(--ground);
  overflow-wrap: anywhere;
  pointer-events: none;
}
.message:empty { display: none; }
.token {
  display: flex;
  flex-wrap: wrap;
  gap: 0.5rem;
  align-items: center;
  justify-content: center;
  width: fit-content;
  max-width: calc(100% - 2rem);
  box-sizing: border-box;
  margin: 0.5rem auto 0;
  padding: 0.5rem 0.9rem;
  border-radius: 0.8rem;
  background: var(--ground);
  pointer-events: auto;
}
.token input {
  width: 11rem;
  min-height: 44px;
  box-sizing: border-box;
  padding: 0 0.6rem;
  border: 1px solid var(--line);
  border-radius: 0.5rem;
  background: transparent;
  color: inherit;
  font: inherit;
}
.foot {
  position: absolute;
  inset-inline: 0.75rem;
  bottom: max(0.75rem, env(safe-area-inset-bottom));
  display: flex;
  flex-direction: column;
  gap: 0.5rem;
  align-items: center;
  max-height: calc(100% - 1.5rem);
  pointer-events: none;
}
.foot > * { max-width: 100%; box-sizing: border-box; margin: 0; pointer-events: auto; }
.bar {
  display: flex;
  flex-wrap: wrap;
  gap: 0.5rem;
  justify-content: center;
  align-items: center;
  padding: 0.4rem;
  border-radius: 0.8rem;
  background: var(--ground);
}
.bar .name { padding-inline: 0.5rem; font-weight: 600; }
.bar .name:empty { display: none; }
button, select {
  min-height: 44px;
  padding: 0 0.9rem;
  border: 1px solid var(--line);
  border-radius: 0.5rem;
  background: transparent;
  color: inherit;
  font: inherit;
}
select { max-width: 14rem; }
select option { background: #17191d; color: #f4f5f7; }
button:hover, select:hover { background: rgb(127 133 145 / 0.3); }
button[aria-pressed="true"] { background: var(--ink); color: #17191d; }
input[type="range"] { width: 6rem; min-height: 44px; margin: 0; accent-color: var(--focus); }
.tap {
  position: absolute;
  inset-inline: 0;
  top: 2.6rem;
  width: fit-content;
  margin: 0 auto;
  pointer-events: auto;
  border-radius: 1.5rem;
  font-weight: 600;
}
.tap, .tap:hover { background: #f4f5f7; color: #17191d; }
.foot .caption {
  padding: 0.3rem 0.8rem;
  border-radius: 0.4rem;
  background: rgb(20 22 26 / 0.86);
  color: #f4f5f7;
  font-size: clamp(1rem, 2.4vw, 1.4rem);
  text-align: center;
  white-space: pre-line;
  overflow-wrap: anywhere;
  pointer-events: none;
}
[hidden] { display: none !important; }
.aus {
  overflow: auto;
  padding: 0.4rem 0.9rem;
  border-radius: 0.8rem;
  background: var(--ground);
}
@media (prefers-color-scheme: light) {
  :host { --ink: #17191d; --ground: rgb(250 250 252 / 0.88); --line: #6b7280; --focus: #0b57d0; }
  select option { background: #fafafc; color: #17191d; }
  button[aria-pressed="true"] { color: #fafafc; }
}
@media (prefers-reduced-motion: no-preference) {
  button, select { transition: background-color 120ms; }
}
@media (max-width: 480px) {
  .bar { gap: 0.35rem; }
  button, select { padding: 0 0.6rem; font-size: 14px; }
  /* A phone has keys for that. */
  input[type="range"] { display: none; }
}
`);
