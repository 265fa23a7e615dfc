import { version } from "../../../package.json";

/** Who made the file; written into every export. */
export const GENERATOR = `Panicle ${version}`;
