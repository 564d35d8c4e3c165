// SPDX-License-Identifier: Apache-2.0
// Starts the page.
import "./style.css";

const host = document.getElementById("app");
if (host) host.textContent = "Feelem";
