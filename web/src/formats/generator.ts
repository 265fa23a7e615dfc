import { version } from "../../../package.json";

/** The name and version of the program, written into every export. */
export const GENERATOR = `Panicle ${version}`;
