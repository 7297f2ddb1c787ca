/** The shaders of web/viewer/shaders, as build.mjs bundles them. */
declare module "sfumato-shaders" {
  export function shaderText(name: string): string;
}
