/** tools/licences.mjs: what stands in the editor besides its own code. */
declare module "virtual:licences" {
  const licences: readonly {
    readonly name: string;
    /** Its short name; null: several, as `text` says. */
    readonly licence: string | null;
    readonly text: string;
  }[];
  export default licences;
}

/** tools/viewer-page.mjs: web/viewer's page with its scripts, shaders and styles, and marks for the rest. */
declare module "virtual:viewer-page" {
  const template: string;
  export default template;
}
