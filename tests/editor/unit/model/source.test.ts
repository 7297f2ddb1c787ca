// The tree over a text is lossless, its errors have places, and edits change only their target.
import { describe, expect, test } from "vitest";
import {
  patchOf,
  setAttribute,
  sf,
  sfName,
  valueOf,
} from "../../../../web/editor/src/source/attributes.js";
import { elementsOf } from "../../../../web/editor/src/source/nodes.js";
import { parse, parseDocument } from "../../../../web/editor/src/source/parse.js";
import { applied, inverse } from "../../../../web/editor/src/source/patch.js";
import type { Edit, Patch } from "../../../../web/editor/src/source/patch.js";
import { SourceError } from "../../../../web/editor/src/source/tree.js";
import type { ElementNode } from "../../../../web/editor/src/source/tree.js";
import { examples, fuzzed, pick, randomNumbers, scenes } from "../corpus.js";

function parsed(text: string): ElementNode | null {
  try {
    return parse(text);
  } catch (error) {
    if (error instanceof SourceError) return null;
    throw error;
  }
}

/** Replaces expect(), which is too slow for millions of calls. */
function hold(condition: boolean): void {
  if (!condition) throw new Error("a place is wrong");
}

/** Returns the text rebuilt only from the tree's places, so that a wrong place gives a wrong text. */
function rebuilt(text: string, root: ElementNode): string {
  const parts: string[] = [];
  let at = 0;
  const copy = (to: number) => {
    if (to < at) throw new Error(`the place ${to} lies before ${at}`);
    parts.push(text.slice(at, to));
    at = to;
  };
  const waiting: (ElementNode | { readonly end: ElementNode })[] = [root];
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    if ("end" in next) {
      copy(next.end.content.end);
      hold(text.startsWith("</" + next.end.name, at));
      copy(next.end.range.end);
      hold(text[at - 1] === ">");
      continue;
    }
    copy(next.range.start);
    hold(text.startsWith("<" + next.name, at));
    for (const attribute of next.attributes) {
      copy(attribute.range.start);
      hold(text.startsWith(attribute.name, at));
      copy(attribute.valueRange.start);
      hold(text[at - 1] === attribute.quote);
      copy(attribute.valueRange.end);
      hold(text[at] === attribute.quote);
      copy(attribute.range.end);
    }
    copy(next.startTag.end);
    hold(text[at - 1] === ">");
    if (next.closesItself) {
      hold(next.range.end === at && next.content.start === at && next.content.end === at);
    } else {
      waiting.push({ end: next });
      for (let i = next.children.length - 1; i >= 0; i -= 1) waiting.push(next.children[i]);
    }
  }
  copy(text.length);
  return parts.join("");
}

const corpus = [...examples(), ...fuzzed(), ...scenes()].map(({ text }) => text);
const readable = corpus.filter((text) => parsed(text) !== null);

describe("the tree is lossless", () => {
  test("on every file of the corpus that parses", () => {
    expect(readable.length).toBeGreaterThan(700);
    for (const text of readable) hold(rebuilt(text, parse(text)) === text);
  }, 60_000);

  test("on 10,000 mutations, of which many parse and none crashes", () => {
    const random = randomNumbers(7);
    const small = readable.filter((text) => text.length < 4000);
    let count = 0;
    for (let i = 0; i < 10_000; i += 1) {
      const [a, b] = [pick(small, random), pick(small, random)];
      const at = Math.floor(random() * a.length);
      const from = Math.floor(random() * b.length);
      const removed = Math.floor(random() * random() * 40);
      const inserted = pick(
        [
          "",
          "<",
          ">",
          "/",
          '"',
          "'",
          "&amp;",
          "<!--",
          "-->",
          "\r\n",
          "<g>",
          "</g>",
          "]]>",
          b.slice(from, from + 20),
        ],
        random,
      );
      const text = a.slice(0, at) + inserted + a.slice(at + removed);
      const root = parsed(text);
      if (!root) continue;
      count += 1;
      hold(rebuilt(text, root) === text);
    }
    expect(count).toBeGreaterThan(1000);
  }, 60_000);

  test("with a BOM, CRLF, CDATA, comments, instructions, a DOCTYPE and either quotes", () => {
    const text = `\ufeff<?xml version='1.0'?>\r\n<!DOCTYPE svg [<!ENTITY a "]>"><!-- ]> --><?x ]>?>]>\r\n<!-- <g> -->
<svg a = 'x"y'\r\n\tb="it's"><![CDATA[<g></x>]]><?php <g> ?><g\n/><!-- </svg> --></svg >\r\n<!-- end -->`;
    const { root, definesEntities } = parseDocument(text);
    expect(rebuilt(text, root)).toBe(text);
    expect(definesEntities).toBe(true);
    expect(root.attributes.map(({ value }) => value)).toEqual(['x"y', "it's"]);
    expect(root.children.map(({ name }) => name)).toEqual(["g"]);
  });

  test("a DOCTYPE without entities defines none", () => {
    const text = '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/x.dtd"><svg/>';
    expect(parseDocument(text).definesEntities).toBe(false);
  });
});

describe("values", () => {
  test("have entities and line ends decoded, and unknown entities as they are", () => {
    const root = parse(
      `<svg a="&lt;&#65;&#x1F600;&apos;&quot;&amp;amp;" b="1\r\n2\t3\r4" c="&ns;&#0;&x" d="&#10;"/>`,
    );
    const values = root.attributes.map(({ value }) => value);
    expect(values).toEqual(["<A\u{1f600}'\"&amp;", "1 2 3 4", "&ns;&#0;&x", "\n"]);
  });

  test("written and read again are the same, between either quotes", () => {
    const value = `a"b'c<d>&e\n\t\r&amp;\u{1f600}`;
    for (const text of ['<svg a="1"/>', "<svg a='1'/>", "<svg/>"]) {
      const after = applied(text, setAttribute(text, parse(text), "a", value));
      expect(valueOf(parse(after), "a")).toBe(value);
    }
  });
});

describe("namespaces", () => {
  test("belong to prefixes where these are declared", () => {
    const root = parse(
      '<svg xmlns="a" xmlns:p="b" p:x="1" y="2"><g xmlns="c" xmlns:p="d" p:x="3"/><p:h q:z="4"/></svg>',
    );
    const [g, h] = root.children;
    expect([root.namespace, g.namespace, h.namespace, h.local]).toEqual(["a", "c", "b", "h"]);
    expect(root.attributes[2].namespace).toBe("b");
    expect(root.attributes[3].namespace).toBe("");
    expect(g.attributes[2].namespace).toBe("d");
    expect(h.attributes[0].namespace).toBe("urn:undeclared:q");
  });
});

describe("errors have words, a line and a column", () => {
  const cases: [text: string, line: number, column: number, reason: RegExp][] = [
    ["<svg>\n <g>\n</svg>", 3, 1, /^the end tag of <g> from line 2 is missing$/],
    ["<svg>\r\n</g></svg>", 2, 1, /^<\/g> ends an element that did not begin$/],
    ["<svg>\n\n<path", 3, 1, /^<path> has no end/],
    ["<svg>\n<g>", 2, 4, /^the end tag of <g> from line 2 is missing$/],
    ["<svg a=1/>", 1, 6, /^the value of a is not in quotes$/],
    ["<svg a/>", 1, 6, /^the attribute a of <svg> has no value$/],
    ['<svg\na="1" a="2"/>', 2, 7, /^<svg> has the attribute a twice$/],
    ['<svg a="1"b="2"/>', 1, 11, /^expected a blank before the attribute b$/],
    ['<svg a="<g b="1"/>', 1, 9, /^"<" in the value of a; a quote is missing$/],
    ["<svg/><svg/>", 1, 7, /^<svg> stands behind the end of the document$/],
    ["<svg/> x", 1, 8, /^there is text outside/],
    ["", 1, 1, /^there is no element/],
    ["<svg><!-- </svg>", 1, 6, /^the comment has no end/],
    ["<svg>a < b</svg>", 1, 8, /^expected a name after "<"/],
  ];
  test.each(cases)("%j", (text, line, column, reason) => {
    let found: unknown;
    try {
      parse(text);
    } catch (error) {
      found = error;
    }
    expect(found).toBeInstanceOf(SourceError);
    const error = found as SourceError;
    expect([error.line, error.column]).toEqual([line, column]);
    expect(error.reason).toMatch(reason);
    expect(error.message).toBe(`Line ${line}, column ${column}: ${error.reason}`);
  });
});

test("100,000 levels are read, or refused in words", () => {
  const deep = 100_000;
  const text = `<svg xmlns:p="a">${'<g xmlns:p="b">'.repeat(deep)}${"</g>".repeat(deep)}</svg>`;
  const root = parse(text);
  expect([...elementsOf(root)].length).toBe(deep + 1);
  expect(() => parse(text.slice(0, -7))).toThrow(SourceError);
});

/** Returns a patch of up to eight edits anywhere in a text. */
function randomPatch(text: string, random: () => number): Patch {
  const places = Array.from({ length: 16 }, () => Math.floor(random() * (text.length + 1)));
  const sorted = places.sort((a, b) => a - b);
  const edits: Edit[] = [];
  for (let i = 0; i < sorted.length; i += 2) {
    if (random() < 0.4) continue;
    const end = random() < 0.3 ? sorted[i] : sorted[i + 1];
    const removed = text.slice(sorted[i], end);
    edits.push({ at: sorted[i], removed, inserted: "x".repeat(Math.floor(random() * 5)) });
  }
  return edits;
}

test("a patch and its inverse, one after the other, change nothing", () => {
  const random = randomNumbers(11);
  for (let i = 0; i < 2000; i += 1) {
    const text = pick(readable, random);
    const patch = randomPatch(text, random);
    const after = applied(text, patch);
    expect(applied(after, inverse(patch))).toBe(text);
    expect(inverse(inverse(patch))).toEqual(patch);
    if (after !== text && patch.some(({ removed }) => removed !== "" && !removed.startsWith("x"))) {
      expect(() => applied("", patch)).toThrow(RangeError);
    }
  }
});

/** Returns all values of all elements, with their places in the tree. */
function values(root: ElementNode): string[] {
  return [...elementsOf(root)].flatMap((element, i) => [
    `${i} ${element.name} ${element.children.length}`,
    ...element.attributes.map(({ name, value }) => `${i} ${name}=${value}`),
  ]);
}

test("an attribute that is set differs, and nothing else does", () => {
  const random = randomNumbers(13);
  for (const { text, name } of examples()) {
    const elements = [...elementsOf(parse(text))];
    for (let i = 0; i < 60; i += 1) {
      const element = pick(elements, random);
      if (element.attributes.length === 0) continue;
      const attribute = pick(element.attributes, random);
      if (attribute.name.startsWith("xmlns")) continue;
      const key = { namespace: attribute.namespace, local: attribute.local };
      const value = `new "${i}" <&>`;
      const edits = setAttribute(text, element, key, value);
      expect(edits.length).toBe(1);
      const after = applied(text, edits);
      const { start, end } = attribute.valueRange;
      expect(after.startsWith(text.slice(0, start)), name).toBe(true);
      expect(after.endsWith(text.slice(end))).toBe(true);
      const [before, now] = [values(parse(text)), values(parse(after))];
      const differing = now.filter((line, k) => line !== before[k]);
      expect(differing).toEqual([`${elements.indexOf(element)} ${attribute.name}=${value}`]);
      const removed = applied(text, setAttribute(text, element, key, null));
      const left = before.filter((_, k) => now[k] === before[k]);
      expect(values(parse(removed))).toEqual(left);
    }
  }
});

describe("a new attribute", () => {
  function set(text: string, name: Parameters<typeof setAttribute>[2], value: string | null) {
    const element = [...elementsOf(parse(text))].at(-1) as ElementNode;
    return applied(text, patchOf(setAttribute(text, element, name, value)));
  }

  test("stands behind the last, parted and quoted as that is", () => {
    expect(set("<svg/>", "a", "1")).toBe('<svg a="1"/>');
    expect(set("<svg ></svg>", "a", "1")).toBe('<svg a="1" ></svg>');
    expect(set("<svg b='2' />", "a", "1")).toBe("<svg b='2' a='1' />");
    expect(set('<svg\n   b="2"\n   c="3" />', "a", "1")).toBe(
      '<svg\n   b="2"\n   c="3"\n   a="1" />',
    );
    expect(set('<svg b="2"\r\n\tc="3"/>', "a", "1")).toBe('<svg b="2"\r\n\tc="3"\r\n\ta="1"/>');
    expect(set('<svg b="2"   c="3"/>', "a", "1")).toBe('<svg b="2"   c="3" a="1"/>');
  });

  test("goes with its blanks", () => {
    expect(set('<svg a="1"\n  b="2"/>', "b", null)).toBe('<svg a="1"/>');
    expect(set('<svg a="1" b="2" />', "a", null)).toBe('<svg b="2" />');
    expect(set("<svg/>", "a", null)).toBe("<svg/>");
  });

  test("of Sfumato has the document's prefix, declared where it is missing", () => {
    const to = sf("left");
    expect(set('<svg xmlns:d="urn:sfumato:1"><g/></svg>', to, "red")).toBe(
      '<svg xmlns:d="urn:sfumato:1"><g d:left="red"/></svg>',
    );
    expect(set("<svg><g/></svg>", to, "red")).toBe(
      '<svg xmlns:sf="urn:sfumato:1" sf:version="1"><g sf:left="red"/></svg>',
    );
    expect(set('<svg xmlns:sf="urn:other"><g/></svg>', to, "red")).toBe(
      '<svg xmlns:sf="urn:other" xmlns:sf2="urn:sfumato:1" sf2:version="1"><g sf2:left="red"/></svg>',
    );
    expect(
      set('<svg xmlns:sf="urn:sfumato:1"><g xmlns:sf="urn:other"/></svg>', to, "red"),
    ).toContain('xmlns:sf2="urn:sfumato:1"');
    expect(set("<svg/>", sf("version"), "1")).toBe(
      '<svg xmlns:sf="urn:sfumato:1" sf:version="1"/>',
    );
    expect(sfName(parse('<svg xmlns:d="urn:sfumato:1"/>'), "left")).toBe("d:left");
    expect(sfName(parse("<svg/>"), "left")).toBe("sf:left");
  });

  test("of two elements at once is declared once", () => {
    const text = "<svg><g/><g/></svg>";
    const root = parse(text);
    const edits = root.children.flatMap((g) => setAttribute(text, g, sf("left"), "red"));
    const after = applied(text, patchOf(edits));
    expect(after).toBe(
      '<svg xmlns:sf="urn:sfumato:1" sf:version="1"><g sf:left="red"/><g sf:left="red"/></svg>',
    );
  });

  test("twice is refused", () => {
    const text = '<svg a="1"/>';
    const edits = ["2", "3"].flatMap((value) => setAttribute(text, parse(text), "a", value));
    expect(() => patchOf(edits)).toThrow(RangeError);
  });
});
