import { MessageError } from "../locale/message_error";
import type { Message } from "../locale/texts";

/** A request that is not answered with a plant: the reason, and the HTTP status. */
export class Refused extends MessageError {
	override name = "Refused";
	constructor(
		readonly status: 400 | 404 | 405 | 413 | 414 | 422 | 500 | 501 | 503,
		message: Message,
		readonly headers: Readonly<Record<string, string>> = {},
	) {
		super(message);
	}
}

/** Headers of an answer with an error. */
export const ERROR_HEADERS = {
	"content-type": "application/json",
	"cache-control": "no-store",
	"access-control-allow-origin": "*",
} as const;

/** Returns the body of an answer with an error, one line of JSON: `{"code":…,"args":…,"message":…}`. */
export const errorBody = ({ code, args, text }: Message): string =>
	`${JSON.stringify({ code, args, message: text })}\n`;
