// The page to begin from: three starts, drawings, recent files, the five steps.
import { Icon, type IconName } from "../../icons.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { ago, date } from "../format.js";
import { useShell, type Beginnings, type Example } from "../services.js";
import { StoredPicture } from "./stored.js";
import { Teaser } from "./teaser.js";
import { Wordmark } from "./wordmark.js";

const words = en.welcome;

function Start(props: {
  readonly icon: IconName;
  readonly title: string;
  readonly text: string;
  readonly onClick: () => void;
}) {
  return (
    <button type="button" class="start" onClick={props.onClick}>
      <Icon name={props.icon} />
      <span>
        <b>{props.title}</b>
        <small>{props.text}</small>
      </span>
    </button>
  );
}

function Gallery({ examples }: { readonly examples: readonly Example[] }) {
  const { editor } = useShell();
  const open = (example: Example) =>
    example.open().catch(() => editor.say(words.exampleFailed(example.name)));
  if (examples.length === 0) return null;
  return (
    <section>
      <h2>{words.begin}</h2>
      <ul class={examples.length > 4 ? "gallery many" : "gallery"}>
        {examples.map((example) => (
          <li key={example.name}>
            <button type="button" onClick={() => void open(example)}>
              <img src={example.thumb} alt="" />
              <span class="gallery-name">
                {example.name}
                <small>{words.curves(example.curves)}</small>
              </span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

/** Drawings that the page shows; Recover lists all. */
const MOST_RECENT = 6;

function Recent({ recent: { value: recent } }: Pick<Beginnings, "recent">) {
  const { editor } = useShell();
  if (recent.length === 0) return null;
  return (
    <section>
      <div class="welcome-head">
        <h2>{words.recent}</h2>
        {recent.length > MOST_RECENT && (
          <button type="button" class="button" onClick={() => editor.command("recover")}>
            {words.allStored(recent.length)}
          </button>
        )}
      </div>
      <ul class="gallery recent-list">
        {recent.slice(0, MOST_RECENT).map(({ name, time, picture, open }) => (
          <li key={`${name} ${time}`}>
            <button type="button" onClick={open} title={date(time)}>
              <StoredPicture picture={picture} />
              <span class="gallery-name">
                <b>{name}</b>
                <small>{words.edited(ago(time))}</small>
              </span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

export function Welcome({ examples, recent }: Beginnings) {
  const { editor } = useShell();
  const begin = (command: string) => () => editor.command(command);
  return (
    <main class="welcome">
      <header class="welcome-bar">
        <Wordmark />
        <span class="spacer" />
        <IconButton icon="contrast" label={en.welcome.theme} command="theme" />
      </header>
      <div class="welcome-body">
        <div class="lede">
          <h1>{words.lede}</h1>
          <p>{words.ledeText}</p>
        </div>
        <div class="starts">
          <Start
            icon="file-plus-2"
            title={words.blank}
            text={words.blankText}
            onClick={begin("new")}
          />
          <Start
            icon="image-plus"
            title={words.photo}
            text={words.photoText}
            onClick={begin("place-photo")}
          />
          <Start
            icon="folder-open"
            title={words.open}
            text={words.openText}
            onClick={begin("open")}
          />
        </div>
        <Recent recent={recent} />
        <Gallery examples={examples} />
        <section>
          <div class="welcome-head">
            <h2>{words.how}</h2>
            <button type="button" class="button" onClick={begin("tour")}>
              <Icon name="play" small />
              {words.tryIt}
            </button>
          </div>
          <Teaser />
        </section>
        <p class="muted welcome-foot">{words.private}</p>
      </div>
    </main>
  );
}
