//! Tests over a real sshd on the local address, if one can be started: a cut connection ends the program.

use crate::session::{PATIENCE, Session, Setup};
use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// A server with its own port and keys; it reads no configuration of the machine.
struct Server {
    process: Child,
    port: u16,
    folder: PathBuf,
}

impl Server {
    /// Starts a server, or returns the reason why it cannot be started.
    fn start(name: &str) -> Result<Server, String> {
        let sshd = ["/usr/sbin/sshd", "/usr/local/sbin/sshd"];
        let sshd = sshd.into_iter().find(|path| Path::new(path).exists());
        let sshd = sshd.ok_or("there is no sshd")?;
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).map_err(|e| e.to_string())?;
        for key in ["host", "user"] {
            let mut keygen = Command::new("ssh-keygen");
            keygen.args(["-q", "-t", "ed25519", "-N", "", "-f"]);
            let made = keygen.arg(folder.join(key)).status();
            made.map_err(|_| "there is no ssh-keygen")?;
        }
        let free = TcpListener::bind("127.0.0.1:0").map_err(|e| e.to_string())?;
        let port = free.local_addr().map_err(|e| e.to_string())?.port();
        drop(free);
        let at = folder.display();
        let configuration = format!(
            "Port {port}\nListenAddress 127.0.0.1\nHostKey {at}/host\n\
             AuthorizedKeysFile {at}/user.pub\nPidFile {at}/pid\nPermitRootLogin prohibit-password\n\
             PasswordAuthentication no\nKbdInteractiveAuthentication no\nUsePAM no\nStrictModes no\n\
             PrintMotd no\nPrintLastLog no\n"
        );
        fs::write(folder.join("conf"), configuration).map_err(|e| e.to_string())?;
        let process = Command::new(sshd)
            .args(["-D", "-e", "-f"])
            .arg(folder.join("conf"))
            .stdin(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|e| e.to_string())?;
        let mut server = Server {
            process,
            port,
            folder,
        };
        let end = Instant::now() + PATIENCE;
        while TcpStream::connect(("127.0.0.1", port)).is_err() {
            if matches!(server.process.try_wait(), Ok(Some(_))) || Instant::now() > end {
                return Err("sshd does not start".into());
            }
            thread::sleep(Duration::from_millis(20));
        }
        Ok(server)
    }

    /// Starts krank over a connection; the remote shell writes its process id to a file.
    fn krank(&self) -> Session {
        let at = self.folder.display();
        let krank = env!("CARGO_BIN_EXE_krank");
        let remote = format!(
            "echo $$ > '{at}/krank.pid'; LC_ALL=C.UTF-8 XDG_STATE_HOME=/dev/null/state \
             XDG_CONFIG_HOME=/nowhere/configuration exec '{krank}' four-bar"
        );
        let (port, key) = (self.port.to_string(), format!("{at}/user"));
        let known = format!("UserKnownHostsFile={at}/known");
        Setup::program(
            "ssh",
            &[
                "-F",
                "none",
                "-tt",
                "-p",
                &port,
                "-i",
                &key,
                "-o",
                "IdentitiesOnly=yes",
                "-o",
                &known,
                "-o",
                "StrictHostKeyChecking=no",
                "-o",
                "LogLevel=ERROR",
                "127.0.0.1",
                &remote,
            ],
        )
        .start()
    }

    fn pid_of_krank(&self) -> i32 {
        let pid = fs::read_to_string(self.folder.join("krank.pid")).unwrap();
        pid.trim().parse().unwrap()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Returns `true` if a process exists and is not a zombie.
fn runs(pid: i32) -> bool {
    let stat = fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
    let state = stat
        .rsplit(')')
        .next()
        .and_then(|rest| rest.trim_start().chars().next());
    !matches!(state, None | Some('Z' | 'X'))
}

#[test]
fn cut_ssh_connection_ends_the_program() {
    let server = match Server::start("sshd-cut") {
        Ok(server) => server,
        Err(reason) => {
            eprintln!("skipped: {reason}");
            return;
        }
    };
    let mut session = server.krank();
    session.wait_for("60.00 deg").wait_for("-3.9164").send(" ");
    session.wait_for("pause");
    let pid = server.pid_of_krank();
    assert!(runs(pid));
    // The line hangs for a while before it is cut.
    let client = session.pid();
    kill_process(client, Signal::STOP).unwrap();
    thread::sleep(Duration::from_millis(500));
    session.child.kill().unwrap();
    let _ = kill_process(client, Signal::KILL);
    let end = Instant::now() + PATIENCE;
    while runs(pid) {
        if Instant::now() > end {
            let _ = kill_process(Pid::from_raw(pid).unwrap(), Signal::KILL);
            panic!("it goes on without anybody to see it");
        }
        thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn quit_over_ssh_restores_the_terminal() {
    let Ok(server) = Server::start("sshd-quit") else {
        eprintln!("skipped: no sshd can be started");
        return;
    };
    let mut session = server.krank();
    session.wait_for("60.00 deg").send(".");
    session.wait_for("65.00 deg").send("q");
    assert!(session.ended_as_found().success());
}
