//! `schlupf explore`: the explorer in a browser, from this machine alone.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::io::{self, Cursor, Read};
use std::net::Ipv4Addr;
use std::path::Path;

use clap::Args;
use tiny_http::{Header, Method, Request, Response, Server, StatusCode};
use zip::ZipArchive;

use crate::arguments::CaseArguments;
use crate::failure::{Failure, SUCCESS};
use crate::read_case::read_case;
use crate::stdout;

/// Which case, and where.
#[derive(Debug, Args)]
pub struct Explore {
    #[command(flatten)]
    pub case: CaseArguments,
    /// Port on this machine [default: any that is free]
    #[arg(long, value_name = "PORT", default_value_t = 0, hide_default_value = true)]
    pub port: u16,
    /// Print the address, but open no browser
    #[arg(long)]
    pub no_browser: bool,
}

/// The page as an archive; empty where the command was built without it.
#[cfg(has_page)]
const PAGE: &[u8] = include_bytes!("../page/page.zip");
#[cfg(not(has_page))]
const PAGE: &[u8] = &[];

/// Files of the page by their paths.
type Page = BTreeMap<String, Vec<u8>>;

/// Serves the page on this machine, until it is interrupted.
pub fn explore(arguments: &Explore) -> Result<u8, Failure> {
    let file = read_case(&arguments.case)?;
    let text = file.edited(&[], Path::new("")).map_err(|error| Failure::Case(error.into()))?;
    let page = page(PAGE)?;
    let listening = Server::http((Ipv4Addr::LOCALHOST, arguments.port));
    let server = listening.map_err(|cause| {
        Failure::Arguments(format!("--port {}: no page can be served: {cause}", arguments.port))
    })?;
    let Some(address) = server.server_addr().to_ip() else {
        return Err(Failure::Arguments("no page can be served: no address".to_owned()));
    };
    let address = format!("http://{address}");
    let with_case = format!("{address}/#toml={}", escaped(&text));
    stdout::write(&format!("The explorer is at {address}/ until Ctrl-C is pressed.\n"))?;
    if !arguments.no_browser && open::that_detached(&with_case).is_err() {
        stdout::write("No browser was found; open that address in one.\n")?;
    }
    for request in server.incoming_requests() {
        // Whoever asked may have gone away.
        let _ = answer(&page, request);
    }
    Ok(SUCCESS)
}

fn page(archive: &[u8]) -> Result<Page, Failure> {
    if archive.is_empty() {
        return Err(Failure::Arguments(
            "this command was built without the explorer; `cargo xtask web` makes it before \
             `cargo build --release`"
                .to_owned(),
        ));
    }
    let read = || -> io::Result<Page> {
        let mut archive = ZipArchive::new(Cursor::new(archive))?;
        let mut page = Page::new();
        for place in 0..archive.len() {
            let mut file = archive.by_index(place)?;
            let mut bytes = Vec::new();
            file.read_to_end(&mut bytes)?;
            page.insert(file.name()?.into_owned(), bytes);
        }
        Ok(page)
    };
    read().map_err(|cause| Failure::file(Path::new("page.zip"), cause))
}

/// Nothing but the page, and only to who calls this machine by its own name: a page from elsewhere
/// whose name leads here is not served.
fn answer(page: &Page, request: Request) -> io::Result<()> {
    let host = request.headers().iter().find(|header| header.field.equiv("Host"));
    let host = host.map(|header| header.value.as_str().to_owned()).unwrap_or_default();
    let name = host.rsplit_once(':').map_or(&*host, |(name, _)| name);
    let path = request.url().split(['?', '#']).next().unwrap_or_default().trim_start_matches('/');
    let path = if path.is_empty() { "index.html" } else { path };
    let is_own = ["127.0.0.1", "localhost"].contains(&name);
    let status = match (request.method(), page.get(path)) {
        _ if !is_own => 403,
        (Method::Get | Method::Head, Some(bytes)) => {
            let kind = Header::from_bytes("Content-Type", content_type(path));
            let mut response = Response::from_data(bytes.as_slice());
            kind.into_iter().for_each(|header| response.add_header(header));
            return request.respond(response);
        }
        (Method::Get | Method::Head, None) => 404,
        _ => 405,
    };
    request.respond(Response::empty(StatusCode(status)))
}

fn content_type(path: &str) -> &'static str {
    match path.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("json" | "webmanifest") => "application/json",
        _ => "application/octet-stream",
    }
}

/// A text as part of an address (RFC 3986).
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(2 * text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
            escaped.push(char::from(byte));
        } else {
            // Writing to a string cannot fail.
            let _ = write!(escaped, "%{byte:02X}");
        }
    }
    escaped
}
