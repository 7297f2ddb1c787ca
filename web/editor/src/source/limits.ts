// Limits of styles: the engine's limits, in include/sfumato/base/limits.hpp.

/** Values that the rules of all sheets set, and parts of their selectors: `style-values`. */
export const STYLE_VALUES = 100_000;
/** Limit of the steps that match selectors of several parts with elements: `selector-steps`. */
export const SELECTOR_STEPS = 10_000_000;
/** Bytes that the var() of all values read and write: `variable-bytes`. */
export const VARIABLE_BYTES = 32 * 2 ** 20;
/** The same, of one value. */
export const VARIABLE_VALUE_BYTES = 2 ** 16;
/** Custom properties and fallbacks of var() within each other: `variable-depth`. */
export const VARIABLE_DEPTH = 32;
/** Bytes of the name of a custom property. */
export const VARIABLE_NAME_BYTES = 256;
/** Custom properties of one block of declarations. */
export const VARIABLES_PER_BLOCK = 10_000;
/** Parts of a selector. */
export const SELECTOR_PARTS = 64;
