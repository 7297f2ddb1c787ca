// The sign and the name.
import { useId } from "preact/hooks";

export function Wordmark() {
  const id = useId();
  return (
    <span class="wordmark">
      <svg viewBox="0 0 24 24" aria-hidden="true">
        <defs>
          <linearGradient id={id} x1="1" x2="0">
            <stop offset=".2" stop-color="currentColor" />
            <stop offset="1" stop-color="currentColor" stop-opacity="0" />
          </linearGradient>
        </defs>
        <path d="M14 1.5C18 8 6 15 10 22.5A11 11 0 0 1 14 1.5Z" fill={`url(#${id})`} />
        <circle cx="12" cy="12" r="10.25" fill="none" stroke="currentColor" stroke-width="1.5" />
        <path
          d="M14 2C18 8 6 15 10 22"
          fill="none"
          stroke="currentColor"
          stroke-width="1.5"
          stroke-linecap="round"
        />
      </svg>
      Sfumato
    </span>
  );
}
