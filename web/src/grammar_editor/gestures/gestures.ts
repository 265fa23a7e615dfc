/** All that gestures are on the page, fetched with the first. */
import "./gesture_bar";

export { GestureInteraction } from "./gesture_interaction";
