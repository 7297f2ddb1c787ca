/** What build.mjs makes of web/viewer/shaders. */
declare module "sfumato-shaders" {
  export function shaderText(name: string): string;
}
