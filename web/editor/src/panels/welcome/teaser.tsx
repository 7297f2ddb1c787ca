// The five steps in five small drawings.
import type { ComponentChildren } from "preact";
import * as en from "../../strings/en.js";

const words = en.welcome;
const BELOW = "M0 72 C36 12 84 12 120 66 V84 H0Z";
const ABOVE = "M0 72 C36 12 84 12 120 66 V0 H0Z";
const BRACKETS = "M44 14V70M44 14h6M44 70h6M76 14V70M76 14h-6M76 70h-6";

const drawings: readonly ComponentChildren[] = [
  <>
    <path d="M14 66 C40 20 80 20 106 60" fill="none" stroke="var(--text)" stroke-width="2" />
    <rect class="teaser-node" x="10.5" y="62.5" width="7" height="7" />
    <rect class="teaser-node" x="102.5" y="56.5" width="7" height="7" />
  </>,
  <>
    <path d={ABOVE} fill="url(#t-up)" />
    <path d={BELOW} fill="url(#t-down)" />
  </>,
  <>
    <path d={ABOVE} fill="url(#t-up)" />
    <path d={BELOW} fill="url(#t-vary)" />
    {(
      [
        [22, 58, "#ffd98a"],
        [60, 44, "#ef6b4a"],
        [98, 56, "#7b2a5a"],
      ] as const
    ).map(([x, y, color]) => (
      <g key={x}>
        <circle cx={x} cy={y} r="5" fill="#fff" stroke="rgb(0 0 0/.6)" />
        <circle cx={x} cy={y} r="3" fill={color} />
      </g>
    ))}
  </>,
  <>
    <rect width="120" height="84" fill="url(#t-blur)" />
    <path d={BRACKETS} fill="none" stroke="rgb(0 0 0/.6)" stroke-width="4" />
    <path d={BRACKETS} fill="none" stroke="#fff" stroke-width="2" />
  </>,
  <>
    <rect width="120" height="84" fill="#37545a" />
    <path d="M20 62 60 44 100 62 60 80Z" fill="#274047" stroke="rgb(255 255 255/.5)" />
    <path d="M20 46 60 28 100 46 60 64Z" fill="#b3404a" stroke="rgb(255 255 255/.7)" />
    <path d="M20 30 60 12 100 30 60 48Z" fill="#f2b75c" stroke="#fff" />
  </>,
];

function Gradients() {
  return (
    <svg class="visually-hidden" width="0" height="0" aria-hidden="true">
      <defs>
        <linearGradient id="t-up" x1="0" y1="0" x2="0" y2="1">
          <stop offset="0" stop-color="#2f6f78" />
          <stop offset="1" stop-color="#a9d6c4" />
        </linearGradient>
        <linearGradient id="t-down" x1="0" y1="0" x2="0" y2="1">
          <stop offset=".3" stop-color="#ffd98a" />
          <stop offset="1" stop-color="#ef8a4a" />
        </linearGradient>
        <linearGradient id="t-vary">
          <stop offset=".1" stop-color="#ffd98a" />
          <stop offset=".5" stop-color="#ef6b4a" />
          <stop offset=".9" stop-color="#7b2a5a" />
        </linearGradient>
        <linearGradient id="t-blur">
          <stop offset=".3" stop-color="#ef8a4a" />
          <stop offset=".7" stop-color="#2f6f78" />
        </linearGradient>
      </defs>
    </svg>
  );
}

export function Teaser() {
  return (
    <>
      <Gradients />
      <ol class="tour">
        {words.steps.map(({ title, text }, index) => (
          <li key={title}>
            <svg viewBox="0 0 120 84" aria-hidden="true" preserveAspectRatio="xMidYMid slice">
              {drawings[index]}
            </svg>
            <h3>
              <span class="step">{index + 1}</span>
              {title}
            </h3>
            <p>{text}</p>
          </li>
        ))}
      </ol>
    </>
  );
}
