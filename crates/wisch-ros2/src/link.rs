//! The connection to DDS: domain and interfaces, topics, and what discovery reports.

use crate::robot_file::{Domain, LinkTable, MappingChoice};
use futures::StreamExt;
use futures::executor::block_on;
use ros2_client::qos::{Durability, History, WhenFull};
use ros2_client::{
    Context, Message, MessageInfo, MessageTypeName, Name, Node, NodeName, NodeOptions, Publisher,
    QosProfile, ServiceMapping,
};
use rustdds::{DomainParticipant, DomainParticipantBuilder, GUID};
use serde::de::DeserializeOwned;
use std::collections::BTreeSet;
use std::fmt;
use std::net::{IpAddr, Ipv4Addr};
use std::time::{Duration, Instant};

/// Samples that a reader keeps: with few of them, a reader that sleeps for 10 ms loses some at 1 kHz.
const STATE_DEPTH: usize = 1000;
/// Samples that services and commands keep.
const SERVICE_DEPTH: usize = 10;
/// Period at which discovery is polled.
const DISCOVERY_PERIOD: Duration = Duration::from_millis(20);

/// An error of the connection, as a sentence for the user.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub(crate) struct LinkError(pub String);

impl LinkError {
    pub fn new(text: impl Into<String>) -> Self {
        Self(text.into())
    }
}

/// Domain and interfaces after the robot file and the environment.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Network {
    pub domain: u16,
    /// Addresses of interfaces; empty for all.
    pub interfaces: Vec<IpAddr>,
}

impl Network {
    /// Returns domain and interfaces. `variable` reads a variable of the environment.
    ///
    /// # Errors
    /// If a variable has an invalid value, or asks for something that this program does not support.
    pub fn choose(
        table: &LinkTable,
        variable: impl Fn(&str) -> Option<String>,
    ) -> Result<Self, LinkError> {
        let set = |name: &str| variable(name).filter(|value| !value.is_empty());
        if let Some(rmw) = set("RMW_IMPLEMENTATION")
            && ![
                "rmw_fastrtps_cpp",
                "rmw_fastrtps_dynamic_cpp",
                "rmw_cyclonedds_cpp",
            ]
            .contains(&rmw.as_str())
        {
            return Err(LinkError::new(format!(
                "RMW_IMPLEMENTATION is {rmw}; expected rmw_fastrtps_cpp or rmw_cyclonedds_cpp, which speak DDS"
            )));
        }
        for name in ["ROS_STATIC_PEERS", "ROS_DISCOVERY_SERVER"] {
            if let Some(value) = set(name) {
                return Err(LinkError::new(format!(
                    "{name} is {value}, and is not supported; unset it, and use multicast or the same computer"
                )));
            }
        }
        let domain = match &table.domain {
            Domain::Number(number) => *number,
            Domain::Word(_) => match set("ROS_DOMAIN_ID") {
                None => 0,
                Some(text) => text.parse().ok().filter(|id| *id <= 232).ok_or_else(|| {
                    LinkError::new(format!("ROS_DOMAIN_ID is {text:?}; expected 0 to 232"))
                })?,
            },
        };
        let is_local = set("ROS_LOCALHOST_ONLY").is_some_and(|value| value == "1");
        let range = set("ROS_AUTOMATIC_DISCOVERY_RANGE");
        let is_local = match range.as_deref() {
            None | Some("SYSTEM_DEFAULT" | "SUBNET") => is_local,
            Some("LOCALHOST") => true,
            Some(other) => {
                return Err(LinkError::new(format!(
                    "ROS_AUTOMATIC_DISCOVERY_RANGE is {other}; expected SUBNET, LOCALHOST or SYSTEM_DEFAULT"
                )));
            }
        };
        let interfaces = if table.interfaces.is_empty() && is_local {
            vec![IpAddr::V4(Ipv4Addr::LOCALHOST)]
        } else {
            table.interfaces.clone()
        };
        Ok(Self { domain, interfaces })
    }
}

impl fmt::Display for Network {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "domain {}", self.domain)?;
        match &self.interfaces[..] {
            [] => f.write_str(", all interfaces"),
            [one] => write!(f, ", interface {one}"),
            several => write!(f, ", interfaces {several:?}"),
        }
    }
}

/// A writer that discovery reports.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct DiscoveredWriter {
    pub guid: GUID,
    pub type_name: String,
    pub is_reliable: bool,
    pub is_latched: bool,
}

/// A node on DDS.
pub(crate) struct Link {
    context: Context,
    node: Node,
    pub network: Network,
    own: BTreeSet<GUID>,
}

impl Link {
    /// Joins the network with a node of this name.
    ///
    /// # Errors
    /// If the environment or DDS refuses.
    pub fn open(table: &LinkTable, name: &str) -> Result<Self, LinkError> {
        let network = Network::choose(table, |name| std::env::var(name).ok())?;
        let failed = |error: String| LinkError(format!("DDS, {network}: {error}"));
        let mut builder = DomainParticipantBuilder::new(network.domain);
        if !network.interfaces.is_empty() {
            builder = builder.with_only_networks(network.interfaces.clone());
        }
        let participant = builder.build().map_err(|error| failed(error.to_string()))?;
        let context = Context::from_domain_participant(participant);
        let context = context.map_err(|error| failed(error.to_string()))?;
        let name = NodeName::new("/", name).map_err(|error| failed(error.to_string()))?;
        let options = NodeOptions::new()
            .enable_rosout(false)
            .start_parameter_services(false);
        let node = context.new_node(name, options);
        let mut node = node.map_err(|error| failed(format!("{error:?}")))?;
        let spinner = node.spinner().map_err(|error| failed(error.to_string()))?;
        std::thread::spawn(move || {
            let _ = block_on(spinner.spin());
        });
        Ok(Self {
            context,
            node,
            network,
            own: BTreeSet::new(),
        })
    }

    /// This program's participant of DDS.
    pub fn participant(&self) -> DomainParticipant {
        self.context.domain_participant()
    }

    pub const fn node(&self) -> &Node {
        &self.node
    }

    pub const fn node_mut(&mut self) -> &mut Node {
        &mut self.node
    }

    /// Subscribes a topic and passes each message to `take`, on a thread of its own.
    ///
    /// A reader of a stream asks for best effort, because then it also hears best-effort writers. A reader of a latched
    /// topic must ask for what it wants.
    pub fn listen<M: Message + DeserializeOwned + Send + 'static>(
        &mut self,
        topic: &str,
        [package, kind]: [&str; 2],
        is_latched: bool,
        mut take: impl FnMut(M, &MessageInfo) + Send + 'static,
    ) -> Result<(), LinkError> {
        let qos = if is_latched {
            latched_qos()
        } else {
            QosProfile::subscription_default().history(History::KeepLast { depth: STATE_DEPTH })
        };
        let failed = |error: String| LinkError(format!("topic {topic}: {error}"));
        let name = Name::parse(topic).map_err(|error| failed(error.to_string()))?;
        let made = (self.node).create_topic(&name, MessageTypeName::new(package, kind), &qos);
        let made = made.map_err(|error| failed(error.to_string()))?;
        let subscription = self.node.create_subscription::<M>(&made, Some(qos));
        let subscription = subscription.map_err(|error| failed(error.to_string()))?;
        std::thread::spawn(move || {
            block_on(subscription.async_stream().for_each(|message| {
                if let Ok((message, info)) = message {
                    take(message, &info);
                }
                async {}
            }));
        });
        Ok(())
    }

    /// Creates a publisher of a topic.
    pub fn publisher<M: Message>(
        &mut self,
        topic: &str,
        [package, kind]: [&str; 2],
        is_latched: bool,
    ) -> Result<Publisher<M>, LinkError> {
        let qos = if is_latched {
            latched_qos()
        } else {
            QosProfile::publisher_default().history(History::KeepLast { depth: STATE_DEPTH })
        };
        let failed = |error: String| LinkError(format!("topic {topic}: {error}"));
        let name = Name::parse(topic).map_err(|error| failed(error.to_string()))?;
        let made = (self.node).create_topic(&name, MessageTypeName::new(package, kind), &qos);
        let made = made.map_err(|error| failed(error.to_string()))?;
        let publisher = self.node.create_publisher::<M>(&made, Some(qos));
        let publisher = publisher.map_err(|error| failed(error.to_string()))?;
        self.own.insert(publisher.guid());
        Ok(publisher)
    }

    /// The writers of a topic with this DDS name, without those of this participant.
    pub fn writers(&self, dds_name: &str) -> Vec<DiscoveredWriter> {
        let participant = self.participant();
        let own = rustdds::RTPSEntity::guid(&participant).prefix;
        let writers = participant.discovered_writers().into_iter();
        writers
            .filter(|writer| writer.publication_topic_data.topic_name == dds_name)
            .filter(|writer| writer.writer_proxy.remote_writer_guid.prefix != own)
            .map(|writer| {
                let data = writer.publication_topic_data;
                DiscoveredWriter {
                    guid: writer.writer_proxy.remote_writer_guid,
                    type_name: data.type_name,
                    // Writers are reliable by default, and Cyclone DDS does not send defaults.
                    is_reliable: data.reliability != Some(rustdds::policy::Reliability::BestEffort),
                    is_latched: matches!(
                        data.durability,
                        Some(rustdds::policy::Durability::TransientLocal)
                    ),
                }
            })
            .collect()
    }

    /// The writers of a ROS 2 topic.
    pub fn publishers(&self, topic: &str) -> Vec<DiscoveredWriter> {
        self.writers(&format!("rt{topic}"))
    }

    /// The server of a service, if discovery reports one.
    pub fn server(&self, service: &str) -> Option<DiscoveredWriter> {
        let writers = self.writers(&format!("rr{service}Reply"));
        writers.into_iter().next()
    }

    /// Chooses the mapping of a service by its server, for which it waits until `deadline`.
    ///
    /// # Errors
    /// If no server is found, or its vendor is unknown and the file leaves the choice to the vendor.
    pub fn mapping(
        &self,
        service: &str,
        choice: MappingChoice,
        deadline: Instant,
    ) -> Result<ServiceMapping, LinkError> {
        let server = loop {
            match self.server(service) {
                Some(server) => break server,
                None if Instant::now() >= deadline => {
                    return Err(LinkError::new(format!(
                        "no service {service} is found ({}); is the robot's driver running, in this domain?",
                        self.network
                    )));
                }
                None => std::thread::sleep(DISCOVERY_PERIOD),
            }
        };
        match (choice, Vendor::from_guid(&server.guid)) {
            (MappingChoice::FastDds, _) => Ok(ServiceMapping::Enhanced),
            (MappingChoice::CycloneDds, _) => Ok(ServiceMapping::Cyclone),
            (MappingChoice::Auto, Vendor::FastDds | Vendor::RustDds) => {
                Ok(ServiceMapping::Enhanced)
            }
            (MappingChoice::Auto, Vendor::CycloneDds) => Ok(ServiceMapping::Cyclone),
            (MappingChoice::Auto, vendor @ Vendor::Unknown(_)) => Err(LinkError::new(format!(
                "the server of {service} is of {vendor}; set link.service_mapping to \"fastdds\" or \"cyclonedds\""
            ))),
        }
    }
}

fn latched_qos() -> QosProfile {
    QosProfile::publisher_default()
        .durability(Durability::TransientLocal)
        .history(History::KeepLast { depth: 1 })
}

/// Quality of service of services and actions.
pub(crate) fn service_qos() -> QosProfile {
    QosProfile::publisher_default()
        .reliability_reliable(WhenFull::DEFAULT)
        .history(History::KeepLast {
            depth: SERVICE_DEPTH,
        })
}

/// A vendor of DDS, by the first two bytes of a GUID.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Vendor {
    FastDds,
    CycloneDds,
    RustDds,
    Unknown([u8; 2]),
}

impl Vendor {
    pub fn from_guid(guid: &GUID) -> Self {
        let bytes = guid.to_bytes();
        match [bytes[0], bytes[1]] {
            [0x01, 0x0f] => Self::FastDds,
            [0x01, 0x10] => Self::CycloneDds,
            [0x01, 0x12] => Self::RustDds,
            other => Self::Unknown(other),
        }
    }
}

impl fmt::Display for Vendor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::FastDds => f.write_str("Fast DDS"),
            Self::CycloneDds => f.write_str("Cyclone DDS"),
            Self::RustDds => f.write_str("RustDDS"),
            Self::Unknown([a, b]) => write!(f, "an unknown vendor of DDS ({a:02x}{b:02x})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn choose(variables: &[(&str, &str)]) -> Result<Network, LinkError> {
        Network::choose(&LinkTable::default(), |name| {
            let found = variables.iter().find(|(key, _)| *key == name);
            found.map(|(_, value)| (*value).to_owned())
        })
    }

    #[test]
    fn domain_and_interfaces_are_those_of_the_environment() {
        let local = vec![IpAddr::V4(Ipv4Addr::LOCALHOST)];
        assert_eq!(choose(&[]).unwrap().to_string(), "domain 0, all interfaces");
        let both = choose(&[("ROS_DOMAIN_ID", "42"), ("ROS_LOCALHOST_ONLY", "1")]).unwrap();
        assert_eq!((both.domain, both.interfaces), (42, local.clone()));
        let range = choose(&[("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")]).unwrap();
        assert_eq!(range.interfaces, local);
    }

    #[test]
    fn a_network_that_is_not_supported_is_refused_with_the_variable() {
        for (name, value) in [
            ("ROS_DOMAIN_ID", "300"),
            ("ROS_DOMAIN_ID", "one"),
            ("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF"),
            ("ROS_STATIC_PEERS", "10.0.0.1"),
            ("ROS_DISCOVERY_SERVER", "10.0.0.1:11811"),
            ("RMW_IMPLEMENTATION", "rmw_zenoh_cpp"),
        ] {
            let error = choose(&[(name, value)]).unwrap_err().to_string();
            assert!(error.contains(name) && error.contains(value), "{error}");
        }
    }

    #[test]
    fn the_vendor_is_that_of_the_guid() {
        let mut bytes = [0; 16];
        bytes[..2].copy_from_slice(&[0x01, 0x10]);
        assert_eq!(
            Vendor::from_guid(&GUID::from_bytes(bytes)),
            Vendor::CycloneDds
        );
        bytes[1] = 0x77;
        let vendor = Vendor::from_guid(&GUID::from_bytes(bytes));
        assert_eq!(vendor.to_string(), "an unknown vendor of DDS (0177)");
    }
}
