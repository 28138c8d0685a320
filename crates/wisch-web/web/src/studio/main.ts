export function startStudio(app: HTMLElement): void { app.textContent = "The studio comes here."; }
