// contract: colours.

/** sRGB code values, each 0 to 1. */
export interface Rgb {
  readonly r: number;
  readonly g: number;
  readonly b: number;
}
