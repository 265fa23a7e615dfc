import { MessageError } from "../locale/message_error";
import type { Message } from "../locale/texts";
import { text } from "./messages.generated";

/** A mistake in a text that is read outside of the core, with its position. */
export class TextError extends MessageError {
	override name = "TextError";
	/** Line and column count from 1. `code` and `args` are those of the problem. */
	constructor(
		readonly line: number,
		readonly column: number,
		problem: Message,
	) {
		super({
			...problem,
			text: text("at_line_and_column", { line: String(line), column: String(column), problem: problem.text }),
		});
	}
}
