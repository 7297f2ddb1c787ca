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
