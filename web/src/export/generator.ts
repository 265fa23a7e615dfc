/** Who made the file; written into every export. The version is that of package.json. */
export const GENERATOR = "Panicle 0.1.0";
