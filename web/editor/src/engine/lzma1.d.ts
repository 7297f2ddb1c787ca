// What is used of lzma1, whose own types are sources that our compiler would check by our rules.

/** @throws Error where it is no LZMA */
export function decompress(data: Uint8Array): Uint8Array<ArrayBuffer>;
