// The viewer's shaders, as text.
import pointWalk from "../../../../src/gather/point_walk.glsl?raw";

const texts = import.meta.glob<string>("../../../viewer/shaders/*", {
  query: "?raw",
  import: "default",
  eager: true,
});

/** @param name of a file in web/viewer/shaders */
export function shaderText(name: string): string {
  const text = name === "point_walk.glsl" ? pointWalk : texts[`../../../viewer/shaders/${name}`];
  if (text === undefined) throw new Error(`there is no shader ${name}`);
  return text;
}
