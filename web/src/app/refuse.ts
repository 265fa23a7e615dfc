/** The message in place of the page where a script that the page needs could not be fetched. */
import { text } from "./messages.generated";

/** Shows the message. */
export function refuse(): void {
	const message = document.createElement("p");
	message.className = "noscript";
	message.role = "alert";
	message.textContent = text("start_failed");
	document.body.append(message);
}
