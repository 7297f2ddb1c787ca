// A titled part of the upper panel.
import type { ComponentChildren } from "preact";

interface SectionProps {
  readonly title: string;
  readonly badge?: string;
  readonly actions?: ComponentChildren;
  readonly children?: ComponentChildren;
}

export function Section({ title, badge, actions, children }: SectionProps) {
  return (
    <section class="section">
      <div class="section-head">
        <h2>{title}</h2>
        {badge && <span class="badge">{badge}</span>}
        {actions}
      </div>
      {children !== undefined && <div class="section-body">{children}</div>}
    </section>
  );
}
