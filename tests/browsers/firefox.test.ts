import { find } from "./browsers.mjs";
import { openFirefox } from "./firefox";
import { smoke } from "./smoke";

smoke("Firefox", (display, downloads) => openFirefox(find("firefox"), display, downloads));
