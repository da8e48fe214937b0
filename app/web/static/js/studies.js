// Studies
import "./page.js";
