// A box to tick, with a note below its label.
export function Check(props: {
  readonly checked: boolean;
  readonly label: string;
  readonly note?: string;
  readonly disabled?: boolean;
  readonly onChange: (to: boolean) => void;
}) {
  return (
    <label class="check">
      <input
        type="checkbox"
        checked={props.checked}
        disabled={props.disabled}
        onChange={(event) => props.onChange(event.currentTarget.checked)}
      />
      <span>
        {props.label}
        {props.note && <small>{props.note}</small>}
      </span>
    </label>
  );
}
