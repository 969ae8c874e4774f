//! `schlupf explore`: the explorer in a browser, from this machine alone.

use std::collections::BTreeMap;
use std::io::{self, Cursor, Read};
use std::net::Ipv4Addr;
use std::path::Path;

use base64::prelude::{BASE64_STANDARD, Engine};
use clap::Args;
use schlupf_case::CaseFile;
use serde_json::json;
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

/// Where the page has the case.
const CASE: &str = "case.json";

/// Files of the page by their paths.
type Page = BTreeMap<String, Vec<u8>>;

/// Serves the page on this machine, until it is interrupted.
pub fn explore(arguments: &Explore) -> Result<u8, Failure> {
    let file = read_case(&arguments.case)?;
    let mut page = page(PAGE)?;
    page.insert(CASE.to_owned(), packed(&file)?);
    let listening = Server::http((Ipv4Addr::LOCALHOST, arguments.port));
    let server = listening.map_err(|cause| {
        Failure::Arguments(format!("--port {}: no page can be served: {cause}", arguments.port))
    })?;
    let Some(address) = server.server_addr().to_ip() else {
        return Err(Failure::Arguments("no page can be served: no address".to_owned()));
    };
    let address = format!("http://{address}/#open={CASE}");
    stdout::write(&format!("The explorer is at {address} until Ctrl-C is pressed.\n"))?;
    if !arguments.no_browser && open::that_detached(&address).is_err() {
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
            if let Ok(header) = kind {
                response.add_header(header);
            }
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

/// A case with its files, as the page reads it.
fn packed(file: &CaseFile) -> Result<Vec<u8>, Failure> {
    let (text, files) = file.packed()?;
    let encoded = files.iter().map(|(name, bytes)| (name, BASE64_STANDARD.encode(bytes)));
    let files: BTreeMap<_, _> = encoded.collect();
    Ok(json!({ "name": file.name(), "text": text, "files": files }).to_string().into_bytes())
}

#[cfg(test)]
mod tests {
    use std::io::{Read, Write};
    use std::net::TcpStream;
    use std::thread;

    use schlupf_case::Overrides;

    use super::*;

    /// What a server of a small page says to a request.
    fn answered(request: &str) -> String {
        let server = Server::http((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let address = server.server_addr().to_ip().unwrap();
        assert!(address.ip().is_loopback());
        let page = Page::from([
            ("index.html".to_owned(), b"<p>page</p>".to_vec()),
            ("assets/solver.wasm".to_owned(), b"\0asm".to_vec()),
        ]);
        let serving = thread::spawn(move || answer(&page, server.recv().unwrap()).unwrap());
        let mut stream = TcpStream::connect(address).unwrap();
        stream.write_all(format!("{request}\r\nConnection: close\r\n\r\n").as_bytes()).unwrap();
        let mut said = String::new();
        stream.read_to_string(&mut said).unwrap();
        serving.join().unwrap();
        said
    }

    #[test]
    fn nothing_but_the_page_is_served() {
        let page = answered("GET /?x=1 HTTP/1.1\r\nHost: 127.0.0.1:8000");
        assert!(page.starts_with("HTTP/1.1 200") && page.ends_with("<p>page</p>"), "{page}");
        let module = answered("GET /assets/solver.wasm HTTP/1.1\r\nHost: localhost");
        assert!(module.contains("application/wasm"), "{module}");
        for path in ["/Cargo.toml", "/../Cargo.toml", "/assets", "//etc/passwd"] {
            let refused = answered(&format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1"));
            assert!(refused.starts_with("HTTP/1.1 404"), "{path}: {refused}");
        }
        let put = answered("PUT / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 0");
        assert!(put.starts_with("HTTP/1.1 405"), "{put}");
    }

    /// A name of another machine that leads here (DNS rebinding).
    #[test]
    fn pages_from_elsewhere_are_not_answered() {
        let refused = answered("GET / HTTP/1.1\r\nHost: example.com");
        assert!(refused.starts_with("HTTP/1.1 403"), "{refused}");
    }

    /// A case of two profiles, of which one is a file, is all that its files are.
    #[test]
    fn a_case_takes_its_files_along() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("own.toml");
        let rail = "y [mm],z [mm]\n-36,-14\n-20,-1\n0,0\n20,-1\n36,-14\n";
        std::fs::write(folder.path().join("rail.csv"), rail).unwrap();
        let text = "rail.profile = \"rail.csv\"\nwheel.profile = \"S1002\"\n\
                    normal = { model = \"wheel-rail\", load = \"60 kN\" }\n";
        std::fs::write(&path, text).unwrap();
        let file = CaseFile::from_path(&path, Overrides::NONE).unwrap();
        let packed: serde_json::Value = serde_json::from_slice(&packed(&file).unwrap()).unwrap();
        assert_eq!(packed["text"], text);
        assert_eq!(packed["files"]["rail.csv"], BASE64_STANDARD.encode(rail));
    }

    #[test]
    fn a_command_without_the_page_says_how_to_get_it() {
        let Err(failure) = page(&[]) else { panic!("there is no page") };
        assert!(failure.to_string().contains("cargo xtask web"), "{failure}");
    }
}
