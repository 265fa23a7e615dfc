/** Notes on places in the text that a plant grows from. */
import type { Message } from "../locale/texts";

/** The codes of notes on a line, and on a line and a column. */
const ON_LINE = "core.expression.at_line";
const ON_COLUMN = "core.expression.at_line_and_column";

/** Returns whether a note is on a place in the text. */
export const isOnText = ({ code }: Pick<Message, "code">): boolean => code === ON_LINE || code === ON_COLUMN;
