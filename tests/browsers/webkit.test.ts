import { find } from "./browsers.mjs";
import { smoke } from "./smoke";
import { openWebKit } from "./webkit";

smoke("WebKit", (display, downloads) => openWebKit(find("webkit"), display, downloads));
