/** tools/page.mjs: web/viewer's page with its scripts, shaders and styles, and marks for the rest. */
declare module "virtual:viewer-page" {
  const template: string;
  export default template;
}
