// Applies the theme that was chosen in the app, before the page is drawn.
try {
	const { theme } = JSON.parse(localStorage.getItem("panicle.ui") ?? "{}");
	if (theme === "light" || theme === "dark") {
		document.documentElement.dataset.theme = theme;
		document.addEventListener("DOMContentLoaded", () => {
			for (const plant of document.querySelectorAll("panicle-specimen")) plant.setAttribute("theme", theme);
		});
	}
} catch {
	// Storage is forbidden or unreadable: the system's theme applies.
}
