"use strict";(()=>{function dm(i,t,e){for(let[n,s]of Object.entries(t))typeof s=="function"?i.addEventListener(n,s):s!=null&&s!==!1&&i.setAttribute(n,s===!0?"":String(s));return i.append(...e.filter(n=>n!=null&&n!==!1)),i}var _=(i,t={},...e)=>dm(document.createElement(i),t,e),ot=(i,t={},...e)=>dm(document.createElementNS("http://www.w3.org/2000/svg",i),t,e);function zt(i,t){i.textContent!==t&&(i.textContent=t)}var tr=i=>_("ul",{class:"w-sentences"},...i.map(t=>_("li",{},String(t)))),bo=(i,t,e="")=>_("table",{},e&&_("caption",{},e),_("thead",{},_("tr",{},...i.map(n=>_("th",{scope:"col"},n)))),_("tbody",{},...t)),_v="\u2212",Gt=(i,t)=>{let e=i.toFixed(t);return/^-0(\.0*)?$/.test(e)?e.slice(1):e.replace("-",_v)},cl=i=>i.charAt(0).toUpperCase()+i.slice(1),hl=i=>i==="transfer"?"free motion":i,Ct=(i,t=0)=>`${Gt(100*i,t)}\u202F%`,An="\u2013",Xe=(i,t)=>typeof i=="number"?t(i):An;function oe(i,t=1){if(i<60)return`${Gt(i,t)} s`;let e=10**t,n=Math.round(i*e)/e,[s,r]=[Math.floor(n/3600),Math.floor(n/60)%60],o=(n%60).toFixed(t).padStart(t?t+3:2,"0");return s?`${s}:${String(r).padStart(2,"0")}:${o}`:`${r}:${o}`}var wv=0,ji=()=>`w${++wv}`;var nn=class{constructor(t=!1,e=256){this.exact=t;this.data=t?new Float64Array(e):new Float32Array(e)}exact;data;length=0;push(t){this.length===this.data.length&&this.reserve(2*this.length),this.data[this.length++]=t}fill(t,e){e>this.data.length&&this.reserve(Math.max(e,2*this.data.length)),e>this.length&&this.data.fill(t,this.length,e),this.length=Math.max(e,this.length)}get last(){return this.length?this.data[this.length-1]:NaN}reserve(t){let e=this.exact?new Float64Array(t):new Float32Array(t);e.set(this.data.subarray(0,this.length)),this.data=e}},Mi=16,_o=class extends nn{levels=[];least=1/0;largest=-1/0;push(t){super.push(t),t<this.least&&(this.least=t),t>this.largest&&(this.largest=t);let[e,n]=[t,t];for(let s=0,r=Mi;this.length%r===0;s++,r*=Mi){let o=s===0?null:this.levels[s-1];[e,n]=[1/0,-1/0];for(let l=0;l<Mi;l++){let c=o?o.data[o.length-2*Mi+2*l]:this.data[this.length-Mi+l],h=o?o.data[o.length-2*Mi+2*l+1]:c;c<e&&(e=c),h>n&&(n=h)}let a=this.levels[s]??=new nn(this.exact,64);a.push(e),a.push(n)}}range(t,e){let[n,s]=[1/0,-1/0],r=Math.max(0,t),o=Math.min(e,this.length);for(;r<o;){let[a,l]=[-1,1];for(;r%(l*Mi)===0&&r+l*Mi<=o&&a+1<this.levels.length;)a++,l*=Mi;let c=r/l,h=a<0?this.data[r]:this.levels[a].data[2*c],u=a<0?h:this.levels[a].data[2*c+1];h<n&&(n=h),u>s&&(s=u),r+=l}return n<=s?[n,s]:null}};function wo(i,t){let[e,n]=[0,i];for(;e<n;){let s=e+n>>1;t(s)?e=s+1:n=s}return e-1}var Gn=(i,t,e=i.length)=>wo(e,n=>i[n]<=t),sn=i=>typeof i=="number"?i:NaN;var er=1e4,ul=32,ve=i=>Float32Array.from(i,t=>sn(t)/er),dl=class{constructor(t){this.steps=t;this.times=t.map(([s])=>sn(s));let e=new Float32Array,n=0;t.forEach((s,r)=>{e=fm(e,s),n=Math.max(n,e.length),r%ul===0&&this.snapshots.push(e)}),this.most=n}steps;times;snapshots=[];index=-1;now=new Float32Array;most;stepAt(t){return Gn(this.times,t)}places(t){if(t<0||!this.steps.length)return new Float32Array;if(t===this.index)return this.now;let e=Math.floor(t/ul),n=this.index>=0&&this.index<t&&this.index>=e*ul,s=n?this.now:this.snapshots[e];for(let r=n?this.index+1:e*ul+1;r<=t;r++)s=fm(s,this.steps[r]);return this.index=t,this.now=s,s}at(t){return this.places(Math.max(0,this.stepAt(t)))}};function fm(i,[,t,e]){let n=new Set(t),s=new Float32Array(Math.max(0,i.length-2*n.size)+e.length),r=0;for(let o=0;o<i.length/2;o++)n.has(o)||(s[r++]=i[2*o],s[r++]=i[2*o+1]);for(let o of e)s[r++]=sn(o)/er;return r===s.length?s:s.slice(0,r)}var fl=class{constructor(t){this.record=t;this.times=t.steps.map(([e])=>sn(e))}record;times;index=-1;now=[];at(t){let e=Math.max(0,Gn(this.times,t));if(e===this.index)return this.now;let n=this.index>=0&&this.index<e,s=n?[...this.now]:Array.from({length:this.record.places.length/2},()=>0);for(let r of this.record.steps.slice(n?this.index+1:0,e+1))this.apply(s,r);return this.index=e,this.now=s,s}get first(){return this.at(-1/0)}get last(){return this.at(1/0)}apply(t,[,e,n]){e.forEach((s,r)=>{s<t.length&&(t[s]=sn(n[r])*this.record.step)})}};var Mv=.1,pm=2,Sv=1,Tv=2,Ev=.3,ml=3,od=.03,gl=class{list=[];taken=0;first=0;extend({data:t,length:e},n){for(;this.taken<e;this.taken++){let s=this.taken;n(s)?s-this.first+1===ml?this.list.push([t[this.first],t[s]]):s-this.first>=ml&&(this.list.at(-1)[1]=t[s]):this.first=s+1}return this.list}},Av=({kind:i,by_hand:t})=>t||/collision/i.test(i),xl=class{constructor(t,e){this.plan=t;this.number=t.round,this.q=Array.from({length:e},()=>new nn(!1,64)),this.particles=new dl(t.particles),this.treated=t.treatment?new fl(t.treatment):null}plan;number;start=0;t=new nn(!0);q;tool=new nn;force=new nn;normal=new _o;height=new _o;particles;treated;interpreted=null;truth=null;observed=null;over=!1;states=null;get target(){let{press_force:t=null}=this.plan;return t!==null&&t>0?t:null}get events(){return this.interpreted?.events??this.plan.events??[]}get count(){return this.t.length}get length(){let t=this.count?this.t.last:0;return this.interpreted?Math.max(this.interpreted.duration,t):this.over&&this.count?t:Math.max(this.plan.duration,t)}get end(){return this.start+this.length}push({t,q:e,tool:n,force:s,normal:r,height:o}){let a=t.length;if(n.length!==7*a||s.length!==3*a||r.length!==a||o.length!==a||Object.values(e).some(h=>h.length!==a))throw new Error("columns of samples differ in length");if(!t.every(Number.isFinite))throw new Error("a time is not finite");let c=this.count;for(let h of t)this.t.push(Math.max(sn(h),this.count?this.t.last:-1/0));this.q.forEach((h,u)=>{let d=e[u];if(d)for(let f of d)h.push(sn(f));else h.fill(c?h.last:0,c+a)});for(let h of n)this.tool.push(sn(h));for(let h of s)this.force.push(sn(h));for(let h of r)this.normal.push(sn(h));for(let h of o)this.height.push(sn(h))}place(t){let e=Math.max(0,Gn(this.t.data,t,this.count)),[n,s]=[this.t.data[e],this.t.data[e+1]];return e+1>=this.count||!(s>n)?[e,0]:[e,Math.min(1,Math.max(0,(t-n)/(s-n)))]}positions(t,e){if(!this.count)return e;let[n,s]=this.place(t);return this.q.forEach(({data:r},o)=>{e[o]=nr(r[n],r[n+1],s)}),e}toolAt(t){if(!this.count)return null;let[e,n]=this.place(t);return Rv(this.tool.data,e,n)}forceAt(t){if(!this.count)return null;let[e,n]=this.place(t),s=r=>nr(this.force.data[3*e+r],this.force.data[3*e+3+r],n);return[s(0),s(1),s(2)]}valueAt(t,e){if(!this.count)return null;let[n,s]=this.place(e),r=nr(t.data[n],t.data[n+1],s);return Number.isFinite(r)?r:null}get firstContact(){return this.plan.phases.find(({contact:t})=>t)?.start??0}growthAt(t){let{growth:e}=this.plan;if(!e.length)return null;let n=e.length-1;for(;n>0&&e[n][0]>t;)n--;let[s,r]=[e[n],e[n+1]];return!r||t<=s[0]||r[0]<=s[0]?s[1]:nr(s[1],r[1],Math.min(1,(t-s[0])/(r[0]-s[0])))}phaseAt(t){let{phases:e}=this.plan,n=-1;return e.forEach((s,r)=>{s.start<=t+1e-9&&(n=r)}),n}get contacts(){let{basis:t,count:e}=this;return this.states?.basis!==t&&(this.states={basis:t,count:-1,pressed:new gl,high:new gl,contact:[],pushed:[]}),this.states.count!==e&&Object.assign(this.states,this.classify(this.states),{count:e}),this.states}contactAt(t){let{contact:e,pushed:n}=this.contacts;return rd(n,t)?"pushed":rd(e,t)?"contact":"none"}isPressed(t){return rd(this.contacts.contact,t)}get basis(){return`${!!this.interpreted} ${this.touchForce}`}get touchForce(){return Mv*pm*Math.floor(Math.max(0,this.normal.largest)/pm)}classify({pressed:t,high:e}){let{normal:n,height:s,plan:r,interpreted:o}=this,a=n.least<=n.largest,l=this.touchForce,c=Math.max(Ev,.5*l),h=o?.contacts??r.contacts,u=this.events.filter(Av).map(({start:g,end:v})=>[g,v]);if(!this.count||!a){let g=r.phases.filter(({contact:v})=>v).map(({start:v,end:S})=>[v,S]);return{contact:pl(h??g),pushed:pl(u)}}let d=g=>s.data[g]>od,f=g=>Math.hypot(this.force.data[3*g],this.force.data[3*g+1],this.force.data[3*g+2]),p=e.extend(this.t,g=>d(g)&&f(g)>Math.max(Tv,l)),x=u.length?pl([...u,...p]):p;if(!h)return{contact:t.extend(this.t,g=>!d(g)&&n.data[g]>Math.max(Sv,l)),pushed:x};let m=([g,v])=>(n.range(this.place(g)[0],this.place(v)[0]+2)?.[1]??0)>c;return{contact:pl(o?.incidents?h:h.filter(m)),pushed:x}}};function rd(i,t){let e=wo(i.length,n=>i[n][0]<=t);return e>=0&&t<=i[e][1]}function pl(i){let t=[];for(let[e,n]of[...i].sort((s,r)=>s[0]-r[0])){let s=t.at(-1);s&&e<=s[1]?s[1]=Math.max(s[1],n):t.push([e,n])}return t}var nr=(i,t,e)=>e>0?i+e*(t-i):i;function Rv(i,t,e){let[n,s]=[7*t,7*t+7],r=Array.from({length:7},(c,h)=>i[n+h]);if(e<=0)return r;let o=0;for(let c=3;c<7;c++)o+=i[n+c]*i[s+c];let a=o<0?-1:1;for(let c=0;c<3;c++)r[c]=nr(r[c],i[s+c],e);for(let c=3;c<7;c++)r[c]=nr(r[c],a*i[s+c],e);let l=Math.hypot(r[3],r[4],r[5],r[6])||1;for(let c=3;c<7;c++)r[c]/=l;return r}var de=i=>typeof i=="string",_t=i=>typeof i=="number"&&Number.isFinite(i),Xt=i=>t=>Array.isArray(t)&&t.every(i),Si=i=>Array.isArray(i),Ki=i=>t=>Array.isArray(t)&&t.length===i&&t.every(_t),Zt=i=>t=>t==null||i(t),Qt=i=>t=>typeof t=="object"&&t!==null&&Object.entries(i).every(([e,n])=>n(t[e])),ir=Ki(7),Mo=Ki(2),mm=Qt({mean:_t,low:_t,high:_t}),Cv=new Map([["box",Qt({size:Ki(3)})],["sphere",Qt({radius:_t})],["mesh",Qt({mesh:_t})],["cylinder",Qt({radius:_t,length:_t})],["capsule",Qt({radius:_t,length:_t})]]),yl=i=>Qt({pose:ir,kind:de,color:Zt(Ki(4))})(i)&&Cv.get(i.kind)?.(i)===!0,gm=Qt({vertices:Xt(_t),triangles:Xt(_t)}),Pv=i=>Qt({radius_m:_t,axis_rad:_t})(i)&&i.kind==="cylinder"&&i.radius_m!==0,Iv=i=>{if(!Qt({points:Xt(_t),places:Xt(_t),triangles:Xt(_t)})(i))return!1;let{kind:t,points:e,places:n,triangles:s}=i,r=e.length/3,o=a=>Number.isInteger(a)&&a>=0&&a<r;return t==="mesh"&&r>0&&n.length===2*r&&s.length>0&&s.length%3===0&&s.every(o)},Lv=i=>{if(!Qt({radius_m:_t,half_angle_rad:_t,axis_rad:_t})(i))return!1;let{kind:t,radius_m:e,half_angle_rad:n}=i;return t==="cone"&&e!==0&&n>0&&n<Math.PI/2},xm=i=>Pv(i)||Lv(i)||Iv(i),Dv=i=>xm(i)||Qt({kind:de})(i)&&i.kind==="plane",ym=Qt({kind:de,start:_t,end:_t,words:de}),Nv=Qt({task:Zt(Qt({target:_t})),tool:Qt({solid:yl}),meshes:Xt(gm),robot:Zt(Qt({variables:Xt(de),links:Xt(Qt({shapes:Xt(yl),collision:Zt(Xt(yl))})),joints:Xt(Qt({parent:_t,pose:ir,axis:Ki(3),offset:_t,terms:Xt(Mo)}))}))}),kv=Qt({strategy:de,chosen:i=>typeof i=="boolean",error:Zt(de),score:Zt(_t),predicted:Zt(_t),lost:Zt(_t),strokes:Zt(_t),in_contact:Zt(_t),duration:Zt(_t),lines:Zt(Xt(Xt(_t)))}),Ov={why:Xt(de),considered:Zt(Xt(kv)),lost:Zt(_t),headings:Zt(Xt(de)),without:Zt(Xt(Qt({stroke:_t,performance:_t,lost:_t,particles:Xt(_t),treated:Zt(Si)}))),another:Zt(Qt({gain:_t,line:Xt(_t),way:_t})),bases:Zt(Qt({poses:Xt(Ki(4)),chosen:Xt(_t)}))},Fv=1e6,Uv=i=>{if(!Qt({unit:de,target:_t,low:_t,high:_t,step:_t,cell:Ki(2),places:Xt(_t),steps:Xt(Si)})(i))return!1;let{unit:t,low:e,high:n,target:s,places:r,steps:o}=i,a=c=>c.length===3&&_t(c[0])&&Xt(_t)(c[1])&&Xt(_t)(c[2]);return(t==="passes"?[s,e,n].every(Number.isInteger):t==="\xB5m"&&e<n)&&n<=Fv&&e>0&&e<=s&&s<=n&&r.length%2===0&&o.every(a)},Bv=Qt({...Ov,round:_t,duration:_t,root:Zt(ir),surface:Qt({pose:ir,rings:Xt(Xt(_t)),shape:Zt(xm)}),scene:Xt(yl),meshes:Xt(gm),goal:Zt(i=>Qt({kind:de})(i)&&(i.kind!=="collected"||Qt({place:Ki(2),radius:_t})(i))),strokes:Xt(Xt(_t)),phases:Xt(Qt({name:de,start:_t,end:_t})),press_force:Zt(_t),predicted:Zt(_t),growth:Xt(Mo),particles:Xt(i=>Array.isArray(i)&&i.length===3&&_t(i[0])&&Si(i[1])&&Si(i[2])),treatment:Zt(Uv),events:Zt(Xt(ym)),contacts:Zt(Xt(Mo))}),zv=Qt({time:Zt(_t),title:de,evidence:de,effect:de,advice:de}),Gv=i=>{if(!Qt({cell:_t,places:Xt(_t),expected:Xt(_t),goal:Zt(_t)})(i))return!1;let{cell:t,places:e,expected:n}=i;return t>0&&e.length===2*n.length},Vv=Qt({round:_t,duration:_t,estimate:mm,by_touch:mm,verdict:de,words:Xt(de),found:Zt(ir),events:Xt(ym),contacts:Xt(Mo),incidents:Zt(Xt(zv)),particles:Si,density:Zt(Gv),treated:Zt(Si)}),Hv=i=>Array.isArray(i)&&de(i[0])&&de(i[1])&&Zt(_t)(i[2]),Wv={head:Nv,round:Bv,interpreted:Vv,stage:Qt({stage:de,words:de}),observed:Qt({round:_t,detections:Si}),truth:Qt({round:_t,performance:Zt(_t),particles:Zt(Si),treated:Zt(Si),pushes:Xt(Mo),surface:Zt(ir),shape:Zt(Dv)}),ended:Qt({verdict:Zt(de),badge:Zt(de),story:Qt({asked:de,happened:de,sure:de,surer:de,next:Zt(Qt({words:de,command:Zt(de)}))}),facts:Xt(Hv)})};function vm(i){let t=i;if(t?.piece==="judged"){let{felt:e,...n}=t;return{by_touch:e,...n,piece:"interpreted"}}if(t?.piece==="round"&&Array.isArray(t.considered)){let e=t.considered.map(n=>n&&"worth"in n?{score:n.worth,...n}:n);return{...t,considered:e}}return i}function bm(i){if(typeof i!="object"||i===null)throw new Error("a line is not a piece");let t=Wv[i.piece];if(t&&!t(i))throw new Error(`a ${i.piece} piece lacks a field`);i.piece==="head"&&$v(i)}function $v({robot:i,tool:t}){if(!i)return;let e=i.joints.length+1;if(i.links.length>e||i.joints.some(({parent:n},s)=>!(n>=0&&n<=s)))throw new Error("a joint comes before its parent, or a link has no joint");if(t.link!==null&&!(t.link<e))throw new Error("the link of the tool does not exist")}function sr(i,t){let e=i?.shape??t;return e&&e.kind!=="plane"?e:null}var hi=class i{head=null;rounds=[];stages=[];meshes=[];observedBefore=null;truthBefore=null;ended=null;broken=0;unknown=0;version=0;closed=!1;callbacks=new Set;cachedHappenings=null;static parse(t){let e=new i,n=0;for(;n<t.length;){let s=t.indexOf(`
`,n);s<0&&(s=t.length),e.applyLine(t.slice(n,s)),n=s+1}return e.close(),e}applyLine(t){if(!t.trim())return;let e;try{e=JSON.parse(t)}catch{this.broken++,this.notify(null);return}this.apply(e)}apply(t){try{this.add(t)}catch{this.broken++}this.notify(t)}close(){this.closed=!0;for(let t of this.rounds)t.over=!0;this.layOutRounds(),this.notify(null)}get live(){return!this.closed&&!this.ended}onChange(t){return this.callbacks.add(t),()=>this.callbacks.delete(t)}notify(t){this.version++;for(let e of this.callbacks)e(t)}add(t){let e=vm(t);switch(bm(e),e.piece){case"head":this.meshes.push(...e.meshes),this.head=e;break;case"stage":this.stages.push(e);break;case"round":{let n=new xl(e,this.head?.robot?.variables.length??0);this.meshes.push(...e.meshes);let s=this.rounds.at(-1);s&&s.number===n.number&&!s.count&&!s.interpreted?this.rounds.pop():s&&(s.over=!0),this.rounds.push(n),this.layOutRounds();break}case"samples":{let n=this.round(e.round);n.push(e),n!==this.rounds.at(-1)&&this.layOutRounds();break}case"observed":e.round===0?this.observedBefore=e:this.round(e.round).observed=e;break;case"interpreted":this.round(e.round).interpreted={...e},this.layOutRounds();break;case"truth":e.round===0?this.truthBefore=e:this.round(e.round).truth=e;break;case"ended":this.ended=e;for(let n of this.rounds)n.over=!0;this.layOutRounds();break;default:this.unknown++}}round(t){for(let e=this.rounds.length-1;e>=0;e--)if(this.rounds[e].number===t)return this.rounds[e];throw new Error(`no round ${t}`)}layOutRounds(){let t=0;for(let e of this.rounds)e.start=t,t+=e.length}get duration(){return this.rounds.at(-1)?.end??0}get now(){let t=this.rounds.at(-1);return!t||!this.live||t.interpreted||t.plan.kind==="planned"?this.duration:t.start+(t.count?t.t.last:0)}roundAt(t){return this.rounds[Math.max(0,wo(this.rounds.length,e=>this.rounds[e].start<=t))]??null}at(t){let e=this.roundAt(t);if(!e)return null;let n=Math.min(Math.max(0,t-e.start),e.length),s=e.valueAt(e.normal,n);return{round:e,time:n,normal:s,q:e.count?e.positions(n,new Float64Array(e.q.length)):new Float64Array,tool:e.toolAt(n),force:e.forceAt(n),height:e.valueAt(e.height,n),performance:e.growthAt(n),contact:e.contactAt(n),phase:e.phaseAt(n)}}outcomeAt(t){for(let r=this.rounds.length-1;r>=0;r--){let o=this.rounds[r];if(o.end>t+1e-6||!(o.interpreted||o.truth||o.observed))continue;let a=o.interpreted?.found??o.plan.surface.pose,{shape:l}=o.plan.surface;return{since:o.end,pose:a,actualPose:o.truth?.surface??a,shape:l,actualShape:sr(o.truth,l),estimated:So(o.interpreted?.particles),actual:So(o.truth?.particles),seen:So(o.observed?.detections)}}let[e]=this.rounds;if(!e||!(this.truthBefore||this.observedBefore))return null;let{pose:n,shape:s}=e.plan.surface;return{since:0,pose:n,actualPose:this.truthBefore?.surface??n,shape:s,actualShape:sr(this.truthBefore,s),estimated:null,actual:So(this.truthBefore?.particles),seen:So(this.observedBefore?.detections)}}endedAt(t){let e=this.rounds.findLastIndex(s=>s.end<=t+1e-6),n=this.rounds[e+1];return n&&t>=n.start+n.firstContact?null:this.rounds[e]??null}resultAt(t){let e=this.endedAt(t);return e?.interpreted?e:null}foundAt(t){return this.rounds.findLast(e=>e.end<=t+1e-6)?.interpreted?.found??null}get happenings(){if(this.cachedHappenings?.version===this.version)return this.cachedHappenings.list;let t=[];for(let{start:e,events:n,truth:s}of this.rounds){for(let r of n)t.push(Xv(r,e));for(let[r,o]of s?.pushes??[])t.push({start:e+r,end:e+o,source:"push",kind:"true push",words:"A push in the simulated world.",byHand:!0})}return t.sort((e,n)=>e.start-n.start),this.cachedHappenings={version:this.version,list:t},t}get stops(){let t=[0,this.duration];for(let{start:e,plan:n}of this.rounds){t.push(e);for(let s of n.phases)s.contact&&t.push(e+s.start)}for(let{start:e}of this.happenings)t.push(e);return[...new Set(t)].filter(e=>e<=this.duration).sort((e,n)=>e-n)}},So=i=>i?ve(i):null,Xv=({kind:i,start:t,end:e,words:n,by_hand:s},r)=>({start:r+t,end:r+e,source:"event",kind:i,words:n,byHand:s});/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var cs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ug=0,$d=1,dg=2;var Fs=1,fg=2,$r=3,us=0,gn=1,cn=2,Us=0,Xr=1,Xd=2,qd=3,Yd=4,pg=5;var Bs=100,mg=101,gg=102,xg=103,yg=104,vg=200,bg=201,_g=202,wg=203,Zd=204,jd=205,Mg=206,Sg=207,Tg=208,Eg=209,Ag=210,Rg=211,Cg=212,Pg=213,Ig=214,ec=0,nc=1,ic=2,Rr=3,sc=4,rc=5,oc=6,ac=7,Sa=0,Lg=1,Dg=2,gi=0,Kd=1,Jd=2,Qd=3,tf=4,ef=5,nf=6,sf=7;var rf=300,zs=301,qr=302,Uc=303,Bc=304,Cr=1e3,fi=1001,lc=1002,Ve=1003,Ng=1004;var Ta=1005;var pn=1006,zc=1007;var Oi=1008;var Mn=1009,of=1010,af=1011,Yr=1012,Gc=1013,ii=1014,Xn=1015,si=1016,Vc=1017,Hc=1018,Gs=1020,lf=35902,cf=35899,hf=1021,uf=1022,ri=1023,Ii=1026,Fi=1027,Wc=1028,$c=1029,ds=1030,Xc=1031;var qc=1033,Ea=33776,Aa=33777,Ra=33778,Ca=33779,Yc=35840,Zc=35841,jc=35842,Kc=35843,Jc=36196,Qc=37492,th=37496,eh=37488,nh=37489,Pa=37490,ih=37491,sh=37808,rh=37809,oh=37810,ah=37811,lh=37812,ch=37813,hh=37814,uh=37815,dh=37816,fh=37817,ph=37818,mh=37819,gh=37820,xh=37821,yh=36492,vh=36494,bh=36495,_h=36283,wh=36284,Ia=36285,Mh=36286;var zo=2300,cc=2301,Ql=2302,Nd=2303,kd=2400,Od=2401,Fd=2402;var kg=3200;var Zr=0,Og=1,Ui="",qe="srgb",Go="srgb-linear",Vo="linear",fe="srgb";var tc=7680;var Fg=519,Ug=512,Bg=513,zg=514,df=515,Gg=516,Vg=517,ff=518,pf=519,mf=35044;var gf="300 es",Hn=2e3,Pr=2001;function qv(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Yv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ho(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Hg(){let i=Ho("canvas");return i.style.display="block",i}var _m={},Ir=null;function Wo(...i){let t="THREE."+i.shift();Ir?Ir("log",t,...i):console.log(t,...i)}function Wg(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Dt(...i){i=Wg(i);let t="THREE."+i.shift();if(Ir)Ir("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Bt(...i){i=Wg(i);let t="THREE."+i.shift();if(Ir)Ir("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Oo(...i){let t=i.join(" ");t in _m||(_m[t]=!0,Dt(...i))}function $g(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Xg={[ec]:ec,[ic]:oc,[sc]:sc,[Rr]:rc,[nc]:nc,[oc]:ic,[ac]:ac,[rc]:Rr},ti=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},rn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],wm=1234567,Tr=Math.PI/180,Lr=180/Math.PI;function Bi(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(rn[i&255]+rn[i>>8&255]+rn[i>>16&255]+rn[i>>24&255]+"-"+rn[t&255]+rn[t>>8&255]+"-"+rn[t>>16&15|64]+rn[t>>24&255]+"-"+rn[e&63|128]+rn[e>>8&255]+"-"+rn[e>>16&255]+rn[e>>24&255]+rn[n&255]+rn[n>>8&255]+rn[n>>16&255]+rn[n>>24&255]).toLowerCase()}function Ht(i,t,e){return Math.max(t,Math.min(e,i))}function xf(i,t){return(i%t+t)%t}function Zv(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function jv(i,t,e){return i!==t?(e-i)/(t-i):0}function Fo(i,t,e){return(1-e)*i+e*t}function Kv(i,t,e,n){return Fo(i,t,1-Math.exp(-e*n))}function Jv(i,t=1){return t-Math.abs(xf(i,t*2)-t)}function Qv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function tb(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function eb(i,t){return i+Math.floor(Math.random()*(t-i+1))}function nb(i,t){return i+Math.random()*(t-i)}function ib(i){return i*(.5-Math.random())}function sb(i){i!==void 0&&(wm=i);let t=wm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function rb(i){return i*Tr}function ob(i){return i*Lr}function ab(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function lb(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function yf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function cb(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:Dt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Sh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function vf(i,t){if(t.constructor===Float32Array)return i;let e=Sh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function bf(i,t){if(t.constructor===Float32Array)return i;let e=Sh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var jr={DEG2RAD:Tr,RAD2DEG:Lr,generateUUID:Bi,clamp:Ht,euclideanModulo:xf,mapLinear:Zv,inverseLerp:jv,lerp:Fo,damp:Kv,pingpong:Jv,smoothstep:Qv,smootherstep:tb,randInt:eb,randFloat:nb,randFloatSpread:ib,seededRandom:sb,degToRad:rb,radToDeg:ob,isPowerOfTwo:ab,ceilPowerOfTwo:lb,floorPowerOfTwo:yf,setQuaternionFromProperEuler:cb,normalize:bf,denormalize:vf},st=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Ht(this.x,t.x,e.x),this.y=Ht(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Ht(this.x,t,e),this.y=Ht(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ht(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Ht(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Le=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let v=Math.acos(m),S=Math.sin(v);g=Math.sin(g*v)/S,a=Math.sin(a*v)/S,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-a*f,t[e+2]=c*p+h*f+a*d-l*u,t[e+3]=h*p-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Dt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Ht(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},A=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Mm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Mm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Ht(this.x,t.x,e.x),this.y=Ht(this.y,t.y,e.y),this.z=Ht(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Ht(this.x,t,e),this.y=Ht(this.y,t,e),this.z=Ht(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ht(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return ad.copy(this).projectOnVector(t),this.sub(ad)}reflect(t){return this.sub(ad.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Ht(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ad=new A,Mm=new Le,Wt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],m=s[3],g=s[6],v=s[1],S=s[4],b=s[7],T=s[2],R=s[5],y=s[8];return r[0]=o*x+a*v+l*T,r[3]=o*m+a*S+l*R,r[6]=o*g+a*b+l*y,r[1]=c*x+h*v+u*T,r[4]=c*m+h*S+u*R,r[7]=c*g+h*b+u*y,r[2]=d*x+f*v+p*T,r[5]=d*m+f*S+p*R,r[8]=d*g+f*b+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Oo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ld.makeScale(t,e)),this}rotate(t){return Oo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ld.makeRotation(-t)),this}translate(t,e){return Oo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ld.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ld=new Wt,Sm=new Wt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Tm=new Wt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function hb(){let i={enabled:!0,workingColorSpace:Go,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===fe&&(s.r=Pi(s.r),s.g=Pi(s.g),s.b=Pi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===fe&&(s.r=Er(s.r),s.g=Er(s.g),s.b=Er(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ui?Vo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Go]:{primaries:t,whitePoint:n,transfer:Vo,toXYZ:Sm,fromXYZ:Tm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:qe},outputColorSpaceConfig:{drawingBufferColorSpace:qe}},[qe]:{primaries:t,whitePoint:n,transfer:fe,toXYZ:Sm,fromXYZ:Tm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:qe}}}),i}var se=hb();function Pi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Er(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var rr,hc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{rr===void 0&&(rr=Ho("canvas")),rr.width=t.width,rr.height=t.height;let s=rr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=rr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Ho("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Pi(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Pi(e[n]/255)*255):e[n]=Pi(e[n]);return{data:e,width:t.width,height:t.height}}else return Dt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},ub=0,Dr=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ub++}),this.uuid=Bi(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(cd(s[o].image)):r.push(cd(s[o]))}else r=cd(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function cd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?hc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Dt("Texture: Unable to serialize Texture."),{})}var db=0,hd=new A,mn=class i extends ti{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=fi,s=fi,r=pn,o=Oi,a=ri,l=Mn,c=i.DEFAULT_ANISOTROPY,h=Ui){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:db++}),this.uuid=Bi(),this.name="",this.source=new Dr(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new st(0,0),this.repeat=new st(1,1),this.center=new st(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Wt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(hd).x}get height(){return this.source.getSize(hd).y}get depth(){return this.source.getSize(hd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Dt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Dt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==rf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Cr:t.x=t.x-Math.floor(t.x);break;case fi:t.x=t.x<0?0:1;break;case lc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Cr:t.y=t.y-Math.floor(t.y);break;case fi:t.y=t.y<0?0:1;break;case lc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};mn.DEFAULT_IMAGE=null;mn.DEFAULT_MAPPING=rf;mn.DEFAULT_ANISOTROPY=1;var pe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(c+1)/2,b=(f+1)/2,T=(g+1)/2,R=(h+d)/4,y=(u+x)/4,E=(p+m)/4;return S>b&&S>T?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=R/n,r=y/n):b>T?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=R/s,r=E/s):T<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),n=y/r,s=E/r),this.set(n,s,r,e),this}let v=Math.sqrt((m-p)*(m-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(m-p)/v,this.y=(u-x)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Ht(this.x,t.x,e.x),this.y=Ht(this.y,t.y,e.y),this.z=Ht(this.z,t.z,e.z),this.w=Ht(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Ht(this.x,t,e),this.y=Ht(this.y,t,e),this.z=Ht(this.z,t,e),this.w=Ht(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ht(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},uc=class extends ti{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:pn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new pe(0,0,t,e),this.scissorTest=!1,this.viewport=new pe(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new mn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:pn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Dr(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},In=class extends uc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},$o=class extends mn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Ve,this.minFilter=Ve,this.wrapR=fi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var dc=class extends mn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Ve,this.minFilter=Ve,this.wrapR=fi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Lt=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m)}set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/or.setFromMatrixColumn(t,0).length(),r=1/or.setFromMatrixColumn(t,1).length(),o=1/or.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d-x*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(fb,t,pb)}lookAt(t,e,n){let s=this.elements;return Rn.subVectors(t,e),Rn.lengthSq()===0&&(Rn.z=1),Rn.normalize(),Ji.crossVectors(n,Rn),Ji.lengthSq()===0&&(Math.abs(n.z)===1?Rn.x+=1e-4:Rn.z+=1e-4,Rn.normalize(),Ji.crossVectors(n,Rn)),Ji.normalize(),vl.crossVectors(Rn,Ji),s[0]=Ji.x,s[4]=vl.x,s[8]=Rn.x,s[1]=Ji.y,s[5]=vl.y,s[9]=Rn.y,s[2]=Ji.z,s[6]=vl.z,s[10]=Rn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],m=n[10],g=n[14],v=n[3],S=n[7],b=n[11],T=n[15],R=s[0],y=s[4],E=s[8],D=s[12],P=s[1],k=s[5],O=s[9],B=s[13],I=s[2],V=s[6],X=s[10],H=s[14],et=s[3],$=s[7],J=s[11],tt=s[15];return r[0]=o*R+a*P+l*I+c*et,r[4]=o*y+a*k+l*V+c*$,r[8]=o*E+a*O+l*X+c*J,r[12]=o*D+a*B+l*H+c*tt,r[1]=h*R+u*P+d*I+f*et,r[5]=h*y+u*k+d*V+f*$,r[9]=h*E+u*O+d*X+f*J,r[13]=h*D+u*B+d*H+f*tt,r[2]=p*R+x*P+m*I+g*et,r[6]=p*y+x*k+m*V+g*$,r[10]=p*E+x*O+m*X+g*J,r[14]=p*D+x*B+m*H+g*tt,r[3]=v*R+S*P+b*I+T*et,r[7]=v*y+S*k+b*V+T*$,r[11]=v*E+S*O+b*X+T*J,r[15]=v*D+S*B+b*H+T*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],v=l*f-c*d,S=a*f-c*u,b=a*d-l*u,T=o*f-c*h,R=o*d-l*h,y=o*u-a*h;return e*(x*v-m*S+g*b)-n*(p*v-m*T+g*R)+s*(p*S-x*T+g*y)-r*(p*b-x*R+m*y)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],v=e*a-n*o,S=e*l-s*o,b=e*c-r*o,T=n*l-s*a,R=n*c-r*a,y=s*c-r*l,E=h*x-u*p,D=h*m-d*p,P=h*g-f*p,k=u*m-d*x,O=u*g-f*x,B=d*g-f*m,I=v*B-S*O+b*k+T*P-R*D+y*E;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return t[0]=(a*B-l*O+c*k)*V,t[1]=(s*O-n*B-r*k)*V,t[2]=(x*y-m*R+g*T)*V,t[3]=(d*R-u*y-f*T)*V,t[4]=(l*P-o*B-c*D)*V,t[5]=(e*B-s*P+r*D)*V,t[6]=(m*b-p*y-g*S)*V,t[7]=(h*y-d*b+f*S)*V,t[8]=(o*O-a*P+c*E)*V,t[9]=(n*P-e*O-r*E)*V,t[10]=(p*R-x*b+g*v)*V,t[11]=(u*b-h*R-f*v)*V,t[12]=(a*D-o*k-l*E)*V,t[13]=(e*k-n*D+s*E)*V,t[14]=(x*S-p*T-m*v)*V,t[15]=(h*T-u*S+d*v)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,m=o*u,g=a*u,v=l*c,S=l*h,b=l*u,T=n.x,R=n.y,y=n.z;return s[0]=(1-(x+g))*T,s[1]=(f+b)*T,s[2]=(p-S)*T,s[3]=0,s[4]=(f-b)*R,s[5]=(1-(d+g))*R,s[6]=(m+v)*R,s[7]=0,s[8]=(p+S)*y,s[9]=(m-v)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=or.set(s[0],s[1],s[2]).length(),a=or.set(s[4],s[5],s[6]).length(),l=or.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Kn.copy(this);let c=1/o,h=1/a,u=1/l;return Kn.elements[0]*=c,Kn.elements[1]*=c,Kn.elements[2]*=c,Kn.elements[4]*=h,Kn.elements[5]*=h,Kn.elements[6]*=h,Kn.elements[8]*=u,Kn.elements[9]*=u,Kn.elements[10]*=u,e.setFromRotationMatrix(Kn),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Hn,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Hn)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Pr)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Hn,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Hn)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Pr)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},or=new A,Kn=new Lt,fb=new A(0,0,0),pb=new A(1,1,1),Ji=new A,vl=new A,Rn=new A,Em=new Lt,Am=new Le,ei=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Ht(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ht(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ht(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ht(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ht(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ht(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Dt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Em.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Em,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Am.setFromEuler(this),this.setFromQuaternion(Am,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ei.DEFAULT_ORDER="XYZ";var Xo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},mb=0,Rm=new A,ar=new Le,Ti=new Lt,bl=new A,To=new A,gb=new A,xb=new Le,Cm=new A(1,0,0),Pm=new A(0,1,0),Im=new A(0,0,1),Lm={type:"added"},yb={type:"removed"},lr={type:"childadded",child:null},ud={type:"childremoved",child:null},De=class i extends ti{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:mb++}),this.uuid=Bi(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new A,e=new ei,n=new Le,s=new A(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Lt},normalMatrix:{value:new Wt}}),this.matrix=new Lt,this.matrixWorld=new Lt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Xo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ar.setFromAxisAngle(t,e),this.quaternion.multiply(ar),this}rotateOnWorldAxis(t,e){return ar.setFromAxisAngle(t,e),this.quaternion.premultiply(ar),this}rotateX(t){return this.rotateOnAxis(Cm,t)}rotateY(t){return this.rotateOnAxis(Pm,t)}rotateZ(t){return this.rotateOnAxis(Im,t)}translateOnAxis(t,e){return Rm.copy(t).applyQuaternion(this.quaternion),this.position.add(Rm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Cm,t)}translateY(t){return this.translateOnAxis(Pm,t)}translateZ(t){return this.translateOnAxis(Im,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ti.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?bl.copy(t):bl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),To.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ti.lookAt(To,bl,this.up):Ti.lookAt(bl,To,this.up),this.quaternion.setFromRotationMatrix(Ti),s&&(Ti.extractRotation(s.matrixWorld),ar.setFromRotationMatrix(Ti),this.quaternion.premultiply(ar.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Bt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Lm),lr.child=t,this.dispatchEvent(lr),lr.child=null):Bt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(yb),ud.child=t,this.dispatchEvent(ud),ud.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ti.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ti.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ti),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Lm),lr.child=t,this.dispatchEvent(lr),lr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(To,t,gb),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(To,xb,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};De.DEFAULT_UP=new A(0,1,0);De.DEFAULT_MATRIX_AUTO_UPDATE=!0;De.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var te=class extends De{constructor(){super(),this.isGroup=!0,this.type="Group"}},vb={type:"move"},Nr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new te,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new te,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new A,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new A),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new te,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new A,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new A,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(vb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new te;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},qg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Qi={h:0,s:0,l:0},_l={h:0,s:0,l:0};function dd(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Mt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=qe){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,se.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=se.workingColorSpace){return this.r=t,this.g=e,this.b=n,se.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=se.workingColorSpace){if(t=xf(t,1),e=Ht(e,0,1),n=Ht(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=dd(o,r,t+1/3),this.g=dd(o,r,t),this.b=dd(o,r,t-1/3)}return se.colorSpaceToWorking(this,s),this}setStyle(t,e=qe){function n(r){r!==void 0&&parseFloat(r)<1&&Dt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Dt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Dt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=qe){let n=qg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Dt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Pi(t.r),this.g=Pi(t.g),this.b=Pi(t.b),this}copyLinearToSRGB(t){return this.r=Er(t.r),this.g=Er(t.g),this.b=Er(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=qe){return se.workingToColorSpace(on.copy(this),t),Math.round(Ht(on.r*255,0,255))*65536+Math.round(Ht(on.g*255,0,255))*256+Math.round(Ht(on.b*255,0,255))}getHexString(t=qe){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=se.workingColorSpace){se.workingToColorSpace(on.copy(this),e);let n=on.r,s=on.g,r=on.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=se.workingColorSpace){return se.workingToColorSpace(on.copy(this),e),t.r=on.r,t.g=on.g,t.b=on.b,t}getStyle(t=qe){se.workingToColorSpace(on.copy(this),t);let e=on.r,n=on.g,s=on.b;return t!==qe?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Qi),this.setHSL(Qi.h+t,Qi.s+e,Qi.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Qi),t.getHSL(_l);let n=Fo(Qi.h,_l.h,e),s=Fo(Qi.s,_l.s,e),r=Fo(Qi.l,_l.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},on=new Mt;Mt.NAMES=qg;var qo=class extends De{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ei,this.environmentIntensity=1,this.environmentRotation=new ei,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Jn=new A,Ei=new A,fd=new A,Ai=new A,cr=new A,hr=new A,Dm=new A,pd=new A,md=new A,gd=new A,xd=new pe,yd=new pe,vd=new pe,di=class i{constructor(t=new A,e=new A,n=new A){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Jn.subVectors(t,e),s.cross(Jn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Jn.subVectors(s,e),Ei.subVectors(n,e),fd.subVectors(t,e);let o=Jn.dot(Jn),a=Jn.dot(Ei),l=Jn.dot(fd),c=Ei.dot(Ei),h=Ei.dot(fd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Ai)===null?!1:Ai.x>=0&&Ai.y>=0&&Ai.x+Ai.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Ai)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ai.x),l.addScaledVector(o,Ai.y),l.addScaledVector(a,Ai.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return xd.setScalar(0),yd.setScalar(0),vd.setScalar(0),xd.fromBufferAttribute(t,e),yd.fromBufferAttribute(t,n),vd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(xd,r.x),o.addScaledVector(yd,r.y),o.addScaledVector(vd,r.z),o}static isFrontFacing(t,e,n,s){return Jn.subVectors(n,e),Ei.subVectors(t,e),Jn.cross(Ei).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Jn.subVectors(this.c,this.b),Ei.subVectors(this.a,this.b),Jn.cross(Ei).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;cr.subVectors(s,n),hr.subVectors(r,n),pd.subVectors(t,n);let l=cr.dot(pd),c=hr.dot(pd);if(l<=0&&c<=0)return e.copy(n);md.subVectors(t,s);let h=cr.dot(md),u=hr.dot(md);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(cr,o);gd.subVectors(t,r);let f=cr.dot(gd),p=hr.dot(gd);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(hr,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return Dm.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(Dm,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(n).addScaledVector(cr,o).addScaledVector(hr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Ne=class{constructor(t=new A(1/0,1/0,1/0),e=new A(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Qn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Qn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Qn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Qn):Qn.fromBufferAttribute(r,o),Qn.applyMatrix4(t.matrixWorld),this.expandByPoint(Qn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),wl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),wl.copy(n.boundingBox)),wl.applyMatrix4(t.matrixWorld),this.union(wl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Qn),Qn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Eo),Ml.subVectors(this.max,Eo),ur.subVectors(t.a,Eo),dr.subVectors(t.b,Eo),fr.subVectors(t.c,Eo),ts.subVectors(dr,ur),es.subVectors(fr,dr),Es.subVectors(ur,fr);let e=[0,-ts.z,ts.y,0,-es.z,es.y,0,-Es.z,Es.y,ts.z,0,-ts.x,es.z,0,-es.x,Es.z,0,-Es.x,-ts.y,ts.x,0,-es.y,es.x,0,-Es.y,Es.x,0];return!bd(e,ur,dr,fr,Ml)||(e=[1,0,0,0,1,0,0,0,1],!bd(e,ur,dr,fr,Ml))?!1:(Sl.crossVectors(ts,es),e=[Sl.x,Sl.y,Sl.z],bd(e,ur,dr,fr,Ml))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Qn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Qn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ri[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ri[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ri[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ri[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ri[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ri[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ri[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ri[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ri),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ri=[new A,new A,new A,new A,new A,new A,new A,new A],Qn=new A,wl=new Ne,ur=new A,dr=new A,fr=new A,ts=new A,es=new A,Es=new A,Eo=new A,Ml=new A,Sl=new A,As=new A;function bd(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){As.fromArray(i,r);let a=s.x*Math.abs(As.x)+s.y*Math.abs(As.y)+s.z*Math.abs(As.z),l=t.dot(As),c=e.dot(As),h=n.dot(As);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Ce=new A,Tl=new st,bb=0,re=class extends ti{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:bb++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=mf,this.updateRanges=[],this.gpuType=Xn,this.version=0,this._normalizationScale=t!==void 0?Sh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Tl.fromBufferAttribute(this,e),Tl.applyMatrix3(t),this.setXY(e,Tl.x,Tl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Ce.fromBufferAttribute(this,e),Ce.applyMatrix3(t),this.setXYZ(e,Ce.x,Ce.y,Ce.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Ce.fromBufferAttribute(this,e),Ce.applyMatrix4(t),this.setXYZ(e,Ce.x,Ce.y,Ce.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Ce.fromBufferAttribute(this,e),Ce.applyNormalMatrix(t),this.setXYZ(e,Ce.x,Ce.y,Ce.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Ce.fromBufferAttribute(this,e),Ce.transformDirection(t),this.setXYZ(e,Ce.x,Ce.y,Ce.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):vf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):bf(t,this.array)}};var Yo=class extends re{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Zo=class extends re{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Vt=class extends re{constructor(t,e,n){super(new Float32Array(t),e,n)}},_b=new Ne,Ao=new A,_d=new A,an=class{constructor(t=new A,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):_b.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ao.subVectors(t,this.center);let e=Ao.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Ao,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(_d.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ao.copy(t.center).add(_d)),this.expandByPoint(Ao.copy(t.center).sub(_d))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},wb=0,Vn=new Lt,wd=new De,pr=new A,Cn=new Ne,Ro=new Ne,Ge=new A,Ft=class i extends ti{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:wb++}),this.uuid=Bi(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(qv(t)?Zo:Yo)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Wt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Vn.makeRotationFromQuaternion(t),this.applyMatrix4(Vn),this}rotateX(t){return Vn.makeRotationX(t),this.applyMatrix4(Vn),this}rotateY(t){return Vn.makeRotationY(t),this.applyMatrix4(Vn),this}rotateZ(t){return Vn.makeRotationZ(t),this.applyMatrix4(Vn),this}translate(t,e,n){return Vn.makeTranslation(t,e,n),this.applyMatrix4(Vn),this}scale(t,e,n){return Vn.makeScale(t,e,n),this.applyMatrix4(Vn),this}lookAt(t){return wd.lookAt(t),wd.updateMatrix(),this.applyMatrix4(wd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(pr).negate(),this.translate(pr.x,pr.y,pr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Vt(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Dt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ne);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Bt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new A(-1/0,-1/0,-1/0),new A(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];Cn.setFromBufferAttribute(r),this.morphTargetsRelative?(Ge.addVectors(this.boundingBox.min,Cn.min),this.boundingBox.expandByPoint(Ge),Ge.addVectors(this.boundingBox.max,Cn.max),this.boundingBox.expandByPoint(Ge)):(this.boundingBox.expandByPoint(Cn.min),this.boundingBox.expandByPoint(Cn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Bt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new an);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Bt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new A,1/0);return}if(t){let n=this.boundingSphere.center;if(Cn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ro.setFromBufferAttribute(a),this.morphTargetsRelative?(Ge.addVectors(Cn.min,Ro.min),Cn.expandByPoint(Ge),Ge.addVectors(Cn.max,Ro.max),Cn.expandByPoint(Ge)):(Cn.expandByPoint(Ro.min),Cn.expandByPoint(Ro.max))}Cn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Ge.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Ge));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ge.fromBufferAttribute(a,c),l&&(pr.fromBufferAttribute(t,c),Ge.add(pr)),s=Math.max(s,n.distanceToSquared(Ge))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Bt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Bt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new re(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let D=0;D<n.count;D++)a[D]=new A,l[D]=new A;let h=new A,u=new A,d=new A,f=new st,p=new st,x=new st,m=new A,g=new A;function v(D,P,k){c[D]=c[P]=c[k]=1,h.fromBufferAttribute(n,D),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,k),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,k),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let O=1/(p.x*x.y-x.x*p.y);isFinite(O)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(O),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(O),a[D].add(m),a[P].add(m),a[k].add(m),l[D].add(g),l[P].add(g),l[k].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let D=0,P=S.length;D<P;++D){let k=S[D],O=k.start,B=k.count;for(let I=O,V=O+B;I<V;I+=3)v(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let b=new A,T=new A,R=new A,y=new A;function E(D){R.fromBufferAttribute(s,D),y.copy(R);let P=a[D];b.copy(P),b.sub(R.multiplyScalar(R.dot(P))).normalize(),T.crossVectors(y,P);let O=T.dot(l[D])<0?-1:1;o.setXYZW(D,b.x,b.y,b.z,O)}for(let D=0,P=n.count;D<P;++D)c[D]&&E(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new re(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new A,r=new A,o=new A,a=new A,l=new A,c=new A,h=new A,u=new A;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Ge.fromBufferAttribute(t,e),Ge.normalize(),t.setXYZ(e,Ge.x,Ge.y,Ge.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new re(d,h,u)}if(this.index===null)return Dt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},kr=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=mf,this.updateRanges=[],this.version=0,this.uuid=Bi()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Nm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Nm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Nm(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Bi()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var dn=new A,Ye=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?Sh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)dn.fromBufferAttribute(this,e),dn.applyMatrix4(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)dn.fromBufferAttribute(this,e),dn.applyNormalMatrix(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)dn.fromBufferAttribute(this,e),dn.transformDirection(t),this.setXYZ(e,dn.x,dn.y,dn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Wo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new re(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Wo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):vf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):bf(t,this.data.array)}},Md=new A,Mb=new A,Sb=new Wt,Pn=class{constructor(t=new A(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Md.subVectors(n,e).cross(Mb.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Md),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Sb.getNormalMatrix(t),s=this.coplanarPoint(Md).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Tb=0,wn=class extends ti{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Tb++}),this.uuid=Bi(),this.name="",this.type="Material",this.blending=Xr,this.side=us,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Zd,this.blendDst=jd,this.blendEquation=Bs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Mt(0,0,0),this.blendAlpha=0,this.depthFunc=Rr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Fg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=tc,this.stencilZFail=tc,this.stencilZPass=tc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Dt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Dt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Mt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Pn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new st().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new st().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Or=class extends wn{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new Mt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},mr,Co=new A,gr=new A,xr=new A,yr=new st,Po=new st,Yg=new Lt,El=new A,Io=new A,Al=new A,km=new st,Sd=new st,Om=new st,Fr=class extends De{constructor(t=new Or){if(super(),this.isSprite=!0,this.type="Sprite",mr===void 0){mr=new Ft;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new kr(e,5);mr.setIndex([0,1,2,0,2,3]),mr.setAttribute("position",new Ye(n,3,0,!1)),mr.setAttribute("uv",new Ye(n,2,3,!1))}this.geometry=mr,this.material=t,this.center=new st(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&Bt('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),gr.setFromMatrixScale(this.matrixWorld),Yg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),xr.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&gr.multiplyScalar(-xr.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Rl(El.set(-.5,-.5,0),xr,o,gr,s,r),Rl(Io.set(.5,-.5,0),xr,o,gr,s,r),Rl(Al.set(.5,.5,0),xr,o,gr,s,r),km.set(0,0),Sd.set(1,0),Om.set(1,1);let a=t.ray.intersectTriangle(El,Io,Al,!1,Co);if(a===null&&(Rl(Io.set(-.5,.5,0),xr,o,gr,s,r),Sd.set(0,1),a=t.ray.intersectTriangle(El,Al,Io,!1,Co),a===null))return;let l=t.ray.origin.distanceTo(Co);l<t.near||l>t.far||e.push({distance:l,point:Co.clone(),uv:di.getInterpolation(Co,El,Io,Al,km,Sd,Om,new st),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Rl(i,t,e,n,s,r){yr.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(Po.x=r*yr.x-s*yr.y,Po.y=s*yr.x+r*yr.y):Po.copy(yr),i.copy(t),i.x+=Po.x,i.y+=Po.y,i.applyMatrix4(Yg)}var Ci=new A,Td=new A,Cl=new A,Pl=new A,pi=class{constructor(t=new A,e=new A(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ci)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ci.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ci.copy(this.origin).addScaledVector(this.direction,e),Ci.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Td.copy(t).add(e).multiplyScalar(.5),Cl.copy(e).sub(t).normalize(),Pl.copy(this.origin).sub(Td);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Cl),a=Pl.dot(this.direction),l=-Pl.dot(Cl),c=Pl.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Td).addScaledVector(Cl,d),f}intersectSphere(t,e){if(t.radius<0)return null;Ci.subVectors(t.center,this.origin);let n=Ci.dot(this.direction),s=Ci.dot(Ci)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ci)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=n.x-o.x,v=n.y-o.y,S=n.z-o.z,b=Math.abs(l),T=Math.abs(c),R=Math.abs(h),y,E,D,P,k,O,B,I,V,X,H,et;if(b>=T&&b>=R?(D=l,O=u,V=p,et=g,l>=0?(y=c,E=h,P=d,k=f,B=x,I=m,X=v,H=S):(y=h,E=c,P=f,k=d,B=m,I=x,X=S,H=v)):T>=R?(D=c,O=d,V=x,et=v,c>=0?(y=h,E=l,P=f,k=u,B=m,I=p,X=S,H=g):(y=l,E=h,P=u,k=f,B=p,I=m,X=g,H=S)):(D=h,O=f,V=m,et=S,h>=0?(y=l,E=c,P=u,k=d,B=p,I=x,X=g,H=v):(y=c,E=l,P=d,k=u,B=x,I=p,X=v,H=g)),D===0)return null;let $=y/D,J=E/D,tt=1/D,wt=P-$*O,Nt=k-J*O,Z=B-$*V,yt=I-J*V,Tt=X-$*et,kt=H-J*et,vt=Tt*yt-kt*Z,Yt=wt*kt-Nt*Tt,Ae=Z*Nt-yt*wt;if(s){if(vt<0||Yt<0||Ae<0)return null}else if((vt<0||Yt<0||Ae<0)&&(vt>0||Yt>0||Ae>0))return null;let Ut=vt+Yt+Ae;if(Ut===0)return null;let me=tt*(vt*O+Yt*V+Ae*et);return(Ut>0?me<0:me>0)?null:this.at(me/Ut,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ln=class extends wn{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Mt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ei,this.combine=Sa,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Fm=new Lt,Rs=new pi,Il=new an,Um=new A,Ll=new A,Dl=new A,Nl=new A,Ed=new A,kl=new A,Bm=new A,Ol=new A,ae=class extends De{constructor(t=new Ft,e=new ln){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){kl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Ed.fromBufferAttribute(u,t),o?kl.addScaledVector(Ed,h):kl.addScaledVector(Ed.sub(e),h))}e.add(kl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Il.copy(n.boundingSphere),Il.applyMatrix4(r),Rs.copy(t.ray).recast(t.near),!(Il.containsPoint(Rs.origin)===!1&&(Rs.intersectSphere(Il,Um)===null||Rs.origin.distanceToSquared(Um)>(t.far-t.near)**2))&&(Fm.copy(r).invert(),Rs.copy(t.ray).applyMatrix4(Fm),!(n.boundingBox!==null&&Rs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Rs)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],v=Math.max(m.start,f.start),S=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,T=S;b<T;b+=3){let R=a.getX(b),y=a.getX(b+1),E=a.getX(b+2);s=Fl(this,g,t,n,c,h,u,R,y,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let v=a.getX(m),S=a.getX(m+1),b=a.getX(m+2);s=Fl(this,o,t,n,c,h,u,v,S,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],v=Math.max(m.start,f.start),S=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,T=S;b<T;b+=3){let R=b,y=b+1,E=b+2;s=Fl(this,g,t,n,c,h,u,R,y,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let v=m,S=m+1,b=m+2;s=Fl(this,o,t,n,c,h,u,v,S,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Eb(i,t,e,n,s,r,o,a){let l;if(t.side===gn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===us,a),l===null)return null;Ol.copy(a),Ol.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Ol);return c<e.near||c>e.far?null:{distance:c,point:Ol.clone(),object:i}}function Fl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Ll),i.getVertexPosition(l,Dl),i.getVertexPosition(c,Nl);let h=Eb(i,t,e,n,Ll,Dl,Nl,Bm);if(h){let u=new A;di.getBarycoord(Bm,Ll,Dl,Nl,u),s&&(h.uv=di.getInterpolatedAttribute(s,a,l,c,u,new st)),r&&(h.uv1=di.getInterpolatedAttribute(r,a,l,c,u,new st)),o&&(h.normal=di.getInterpolatedAttribute(o,a,l,c,u,new A),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new A,materialIndex:0};di.getNormal(Ll,Dl,Nl,d.normal),h.face=d,h.barycoord=u}return h}var jo=class extends mn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Ve,h=Ve,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ur=class extends re{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},vr=new Lt,zm=new Lt,Ul=[],Gm=new Ne,Ab=new Lt,Lo=new ae,Do=new an,Ko=class extends ae{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Ur(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Ab)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Ne),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,vr),Gm.copy(t.boundingBox).applyMatrix4(vr),this.boundingBox.union(Gm)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new an),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,vr),Do.copy(t.boundingSphere).applyMatrix4(vr),this.boundingSphere.union(Do)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(Lo.geometry=this.geometry,Lo.material=this.material,Lo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Do.copy(this.boundingSphere),Do.applyMatrix4(n),t.ray.intersectsSphere(Do)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,vr),zm.multiplyMatrices(n,vr),Lo.matrixWorld=zm,Lo.raycast(t,Ul);for(let o=0,a=Ul.length;o<a;o++){let l=Ul[o];l.instanceId=r,l.object=this,e.push(l)}Ul.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Ur(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new jo(new Float32Array(s*this.count),s,this.count,Wc,Xn));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Cs=new an,Rb=new st(.5,.5),Bl=new A,is=class{constructor(t=new Pn,e=new Pn,n=new Pn,s=new Pn,r=new Pn,o=new Pn){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Hn,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],v=r[12],S=r[13],b=r[14],T=r[15];if(s[0].setComponents(c-o,f-h,g-p,T-v).normalize(),s[1].setComponents(c+o,f+h,g+p,T+v).normalize(),s[2].setComponents(c+a,f+u,g+x,T+S).normalize(),s[3].setComponents(c-a,f-u,g-x,T-S).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,g-m,T-b).normalize();else if(s[4].setComponents(c-l,f-d,g-m,T-b).normalize(),e===Hn)s[5].setComponents(c+l,f+d,g+m,T+b).normalize();else if(e===Pr)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Cs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Cs.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Cs)}intersectsSprite(t){Cs.center.set(0,0,0);let e=Rb.distanceTo(t.center);return Cs.radius=.7071067811865476+e,Cs.applyMatrix4(t.matrixWorld),this.intersectsSphere(Cs)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Bl.x=s.normal.x>0?t.max.x:t.min.x,Bl.y=s.normal.y>0?t.max.y:t.min.y,Bl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Bl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Vm=new Lt,fc=class i{constructor(){this.coordinateSystem=Hn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Vm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new is),n[s].setFromProjectionMatrix(Vm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new is),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Ps=class extends wn{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Mt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},pc=new A,mc=new A,Hm=new Lt,No=new pi,zl=new an,Ad=new A,Wm=new A,gc=class extends De{constructor(t=new Ft,e=new Ps){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)pc.fromBufferAttribute(e,s-1),mc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=pc.distanceTo(mc);t.setAttribute("lineDistance",new Vt(n,1))}else Dt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),zl.copy(n.boundingSphere),zl.applyMatrix4(s),zl.radius+=r,t.ray.intersectsSphere(zl)===!1)return;Hm.copy(s).invert(),No.copy(t.ray).applyMatrix4(Hm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=h.getX(x),v=h.getX(x+1),S=Gl(this,t,No,l,g,v,x);S&&e.push(S)}if(this.isLineLoop){let x=h.getX(p-1),m=h.getX(f),g=Gl(this,t,No,l,x,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=Gl(this,t,No,l,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=Gl(this,t,No,l,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Gl(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(pc.fromBufferAttribute(a,s),mc.fromBufferAttribute(a,r),e.distanceSqToSegment(pc,mc,Ad,Wm)>n)return;Ad.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Ad);if(!(c<t.near||c>t.far))return{distance:c,point:Wm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var $m=new A,Xm=new A,Br=class extends gc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)$m.fromBufferAttribute(e,s),Xm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+$m.distanceTo(Xm);t.setAttribute("lineDistance",new Vt(n,1))}else Dt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Wn=class extends wn{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Mt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},qm=new Lt,Ud=new pi,Vl=new an,Hl=new A,ni=class extends De{constructor(t=new Ft,e=new Wn){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Vl.copy(n.boundingSphere),Vl.applyMatrix4(s),Vl.radius+=r,t.ray.intersectsSphere(Vl)===!1)return;qm.copy(s).invert(),Ud.copy(t.ray).applyMatrix4(qm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,x=f;p<x;p++){let m=c.getX(p);Hl.fromBufferAttribute(u,m),Ym(Hl,m,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,x=f;p<x;p++)Hl.fromBufferAttribute(u,p),Ym(Hl,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ym(i,t,e,n,s,r,o){let a=Ud.distanceSqToPoint(i);if(a<e){let l=new A;Ud.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Jo=class extends mn{constructor(t=[],e=zs,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Li=class extends mn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Di=class extends mn{constructor(t,e,n=ii,s,r,o,a=Ve,l=Ve,c,h=Ii,u=1){if(h!==Ii&&h!==Fi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Dr(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Qo=class extends Di{constructor(t,e=ii,n=zs,s,r,o=Ve,a=Ve,l,c=Ii){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ta=class extends mn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ln=class i extends Ft{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Vt(c,3)),this.setAttribute("normal",new Vt(h,3)),this.setAttribute("uv",new Vt(u,2));function p(x,m,g,v,S,b,T,R,y,E,D){let P=b/y,k=T/E,O=b/2,B=T/2,I=R/2,V=y+1,X=E+1,H=0,et=0,$=new A;for(let J=0;J<X;J++){let tt=J*k-B;for(let wt=0;wt<V;wt++){let Nt=wt*P-O;$[x]=Nt*v,$[m]=tt*S,$[g]=I,c.push($.x,$.y,$.z),$[x]=0,$[m]=0,$[g]=R>0?1:-1,h.push($.x,$.y,$.z),u.push(wt/y),u.push(1-J/E),H+=1}}for(let J=0;J<E;J++)for(let tt=0;tt<y;tt++){let wt=d+tt+V*J,Nt=d+tt+V*(J+1),Z=d+(tt+1)+V*(J+1),yt=d+(tt+1)+V*J;l.push(wt,Nt,yt),l.push(Nt,Z,yt),et+=6}a.addGroup(f,et,D),f+=et,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Is=class i extends Ft{constructor(t=1,e=1,n=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:n,radialSegments:s,heightSegments:r},e=Math.max(0,e),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],h=e/2,u=Math.PI/2*t,d=e,f=2*u+d,p=n*2+r,x=s+1,m=new A,g=new A;for(let v=0;v<=p;v++){let S=0,b=0,T=0,R=0;if(v<=n){let D=v/n,P=D*Math.PI/2;b=-h-t*Math.cos(P),T=t*Math.sin(P),R=-t*Math.cos(P),S=D*u}else if(v<=n+r){let D=(v-n)/r;b=-h+D*e,T=t,R=0,S=u+D*d}else{let D=(v-n-r)/n,P=D*Math.PI/2;b=h+t*Math.sin(P),T=t*Math.cos(P),R=t*Math.sin(P),S=u+d+D*u}let y=Math.max(0,Math.min(1,S/f)),E=0;v===0?E=.5/s:v===p&&(E=-.5/s);for(let D=0;D<=s;D++){let P=D/s,k=P*Math.PI*2,O=Math.sin(k),B=Math.cos(k);g.x=-T*B,g.y=b,g.z=T*O,a.push(g.x,g.y,g.z),m.set(-T*B,R,T*O),m.normalize(),l.push(m.x,m.y,m.z),c.push(P+E,y)}if(v>0){let D=(v-1)*x;for(let P=0;P<s;P++){let k=D+P,O=D+P+1,B=v*x+P,I=v*x+P+1;o.push(k,O,B),o.push(O,I,B)}}}this.setIndex(o),this.setAttribute("position",new Vt(a,3)),this.setAttribute("normal",new Vt(l,3)),this.setAttribute("uv",new Vt(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},ss=class i extends Ft{constructor(t=1,e=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:n,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new A,h=new st;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=e;u++,d+=3){let f=n+u/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/t+1)/2,h.y=(o[d+1]/t+1)/2,l.push(h.x,h.y)}for(let u=1;u<=e;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new Vt(o,3)),this.setAttribute("normal",new Vt(a,3)),this.setAttribute("uv",new Vt(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.segments,t.thetaStart,t.thetaLength)}},rs=class i extends Ft{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],m=n/2,g=0;v(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new Vt(u,3)),this.setAttribute("normal",new Vt(d,3)),this.setAttribute("uv",new Vt(f,2));function v(){let b=new A,T=new A,R=0,y=(e-t)/n;for(let E=0;E<=r;E++){let D=[],P=E/r,k=P*(e-t)+t;for(let O=0;O<=s;O++){let B=O/s,I=B*l+a,V=Math.sin(I),X=Math.cos(I);T.x=k*V,T.y=-P*n+m,T.z=k*X,u.push(T.x,T.y,T.z),b.set(V,y,X).normalize(),d.push(b.x,b.y,b.z),f.push(B,1-P),D.push(p++)}x.push(D)}for(let E=0;E<s;E++)for(let D=0;D<r;D++){let P=x[D][E],k=x[D+1][E],O=x[D+1][E+1],B=x[D][E+1];(t>0||D!==0)&&(h.push(P,k,B),R+=3),(e>0||D!==r-1)&&(h.push(k,O,B),R+=3)}c.addGroup(g,R,0),g+=R}function S(b){let T=p,R=new st,y=new A,E=0,D=b===!0?t:e,P=b===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*P,0),d.push(0,P,0),f.push(.5,.5),p++;let k=p;for(let O=0;O<=s;O++){let I=O/s*l+a,V=Math.cos(I),X=Math.sin(I);y.x=D*X,y.y=m*P,y.z=D*V,u.push(y.x,y.y,y.z),d.push(0,P,0),R.x=V*.5+.5,R.y=X*.5*P+.5,f.push(R.x,R.y),p++}for(let O=0;O<s;O++){let B=T+O,I=k+O;b===!0?h.push(I,I+1,B):h.push(I+1,I,B),E+=3}c.addGroup(g,E,b===!0?1:2),g+=E}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ls=class i extends rs{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Wl=new A,$l=new A,Rd=new A,Xl=new di,ea=class extends Ft{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Tr*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:x,b:m,c:g}=Xl;if(x.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),Xl.getNormal(Rd),u[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let S=(v+1)%3,b=u[v],T=u[S],R=Xl[h[v]],y=Xl[h[S]],E=`${b}_${T}`,D=`${T}_${b}`,P=d.get(D);P?(Rd.dot(P.normal)<=r&&(f.push(R.x,R.y,R.z),f.push(y.x,y.y,y.z)),d.set(D,null)):d.has(E)||d.set(E,{index0:c[v],index1:c[S],normal:Rd.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:m}=p;Wl.fromBufferAttribute(a,x),$l.fromBufferAttribute(a,m),f.push(Wl.x,Wl.y,Wl.z),f.push($l.x,$l.y,$l.z)}this.setAttribute("position",new Vt(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},Dn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Dt("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new st:new A);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new A,s=[],r=[],o=[],a=new A,l=new Lt;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new A)}r[0]=new A,o[0]=new A;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(Ht(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(Ht(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},zr=class extends Dn{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new st){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},xc=class extends zr{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function _f(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var Zm=new A,jm=new A,Cd=new _f,Pd=new _f,Id=new _f,yc=class extends Dn{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new A){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(jm.subVectors(s[0],s[1]).add(s[0]),c=jm);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(Zm.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Zm),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),x=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);x<1e-4&&(x=1),p<1e-4&&(p=x),m<1e-4&&(m=x),Cd.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,x,m),Pd.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,x,m),Id.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,x,m)}else this.curveType==="catmullrom"&&(Cd.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),Pd.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Id.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(Cd.calc(l),Pd.calc(l),Id.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new A().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Km(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function Cb(i,t){let e=1-i;return e*e*t}function Pb(i,t){return 2*(1-i)*i*t}function Ib(i,t){return i*i*t}function Uo(i,t,e,n){return Cb(i,t)+Pb(i,e)+Ib(i,n)}function Lb(i,t){let e=1-i;return e*e*e*t}function Db(i,t){let e=1-i;return 3*e*e*i*t}function Nb(i,t){return 3*(1-i)*i*i*t}function kb(i,t){return i*i*i*t}function Bo(i,t,e,n,s){return Lb(i,t)+Db(i,e)+Nb(i,n)+kb(i,s)}var na=class extends Dn{constructor(t=new st,e=new st,n=new st,s=new st){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new st){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Bo(t,s.x,r.x,o.x,a.x),Bo(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},vc=class extends Dn{constructor(t=new A,e=new A,n=new A,s=new A){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new A){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Bo(t,s.x,r.x,o.x,a.x),Bo(t,s.y,r.y,o.y,a.y),Bo(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},ia=class extends Dn{constructor(t=new st,e=new st){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new st){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new st){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},bc=class extends Dn{constructor(t=new A,e=new A){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new A){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new A){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},sa=class extends Dn{constructor(t=new st,e=new st,n=new st){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new st){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(Uo(t,s.x,r.x,o.x),Uo(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},_c=class extends Dn{constructor(t=new A,e=new A,n=new A){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new A){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(Uo(t,s.x,r.x,o.x),Uo(t,s.y,r.y,o.y),Uo(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ra=class extends Dn{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new st){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(Km(a,l.x,c.x,h.x,u.x),Km(a,l.y,c.y,h.y,u.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new st().fromArray(s))}return this}},Jm=Object.freeze({__proto__:null,ArcCurve:xc,CatmullRomCurve3:yc,CubicBezierCurve:na,CubicBezierCurve3:vc,EllipseCurve:zr,LineCurve:ia,LineCurve3:bc,QuadraticBezierCurve:sa,QuadraticBezierCurve3:_c,SplineCurve:ra}),wc=class extends Dn{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Jm[n](e,t))}return this}getPoint(t,e){let n=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(e.push(h),n=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(new Jm[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},oa=class extends wc{constructor(t){super(),this.type="Path",this.currentPoint=new st,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let n=new ia(this.currentPoint.clone(),new st(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){let r=new sa(this.currentPoint.clone(),new st(t,e),new st(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){let a=new na(this.currentPoint.clone(),new st(t,e),new st(n,s),new st(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),n=new ra(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){let c=new zr(t,e,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},Ni=class extends oa{constructor(t){super(t),this.uuid=Bi(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let n=0,s=this.holes.length;n<s;n++)e[n]=this.holes[n].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,n=this.holes.length;e<n;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(new oa().fromJSON(s))}return this}};function Ob(i,t,e=2){let n=t&&t.length,s=n?t[0]*e:i.length,r=Zg(i,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=Gb(i,t,r,e)),i.length>80*e){a=i[0],l=i[1];let h=a,u=l;for(let d=e;d<s;d+=e){let f=i[d],p=i[d+1];f<a&&(a=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return aa(r,o,e,a,l,c,0),o}function Zg(i,t,e,n,s){let r;if(s===Jb(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=Qm(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=Qm(o/n|0,i[o],i[o+1],r);return r&&Gr(r,r.next)&&(ca(r),r=r.next),r}function Ds(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(Gr(e,e.next)||Ee(e.prev,e,e.next)===0)){if(ca(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function aa(i,t,e,n,s,r,o){if(!i)return;!o&&r&&Xb(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?Ub(i,n,s,r):Fb(i)){t.push(l.i,i.i,c.i),ca(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=Bb(Ds(i),t),aa(i,t,e,n,s,r,2)):o===2&&zb(i,t,e,n,s,r):aa(Ds(i),t,e,n,s,r,1);break}}}function Fb(i){let t=i.prev,e=i,n=i.next;if(Ee(t,e,n)>=0)return!1;let s=t.x,r=e.x,o=n.x,a=t.y,l=e.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),p=n.next;for(;p!==t;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&ko(s,a,r,l,o,c,p.x,p.y)&&Ee(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function Ub(i,t,e,n){let s=i.prev,r=i,o=i.next;if(Ee(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),p=Math.min(h,u,d),x=Math.max(a,l,c),m=Math.max(h,u,d),g=Bd(f,p,t,e,n),v=Bd(x,m,t,e,n),S=i.prevZ,b=i.nextZ;for(;S&&S.z>=g&&b&&b.z<=v;){if(S.x>=f&&S.x<=x&&S.y>=p&&S.y<=m&&S!==s&&S!==o&&ko(a,h,l,u,c,d,S.x,S.y)&&Ee(S.prev,S,S.next)>=0||(S=S.prevZ,b.x>=f&&b.x<=x&&b.y>=p&&b.y<=m&&b!==s&&b!==o&&ko(a,h,l,u,c,d,b.x,b.y)&&Ee(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;S&&S.z>=g;){if(S.x>=f&&S.x<=x&&S.y>=p&&S.y<=m&&S!==s&&S!==o&&ko(a,h,l,u,c,d,S.x,S.y)&&Ee(S.prev,S,S.next)>=0)return!1;S=S.prevZ}for(;b&&b.z<=v;){if(b.x>=f&&b.x<=x&&b.y>=p&&b.y<=m&&b!==s&&b!==o&&ko(a,h,l,u,c,d,b.x,b.y)&&Ee(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function Bb(i,t){let e=i;do{let n=e.prev,s=e.next.next;!Gr(n,s)&&Kg(n,e,e.next,s)&&la(n,s)&&la(s,n)&&(t.push(n.i,e.i,s.i),ca(e),ca(e.next),e=i=s),e=e.next}while(e!==i);return Ds(e)}function zb(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&Zb(o,a)){let l=Jg(o,a);o=Ds(o,o.next),l=Ds(l,l.next),aa(o,t,e,n,s,r,0),aa(l,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function Gb(i,t,e,n){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*n,l=r<o-1?t[r+1]*n:i.length,c=Zg(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(Yb(c))}s.sort(Vb);for(let r=0;r<s.length;r++)e=Hb(s[r],e);return e}function Vb(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function Hb(i,t){let e=Wb(i,t);if(!e)return t;let n=Jg(e,i);return Ds(n,n.next),Ds(e,e.next)}function Wb(i,t){let e=t,n=i.x,s=i.y,r=-1/0,o;if(Gr(i,e))return e;do{if(Gr(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let u=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(u<=n&&u>r&&(r=u,o=e.x<e.next.x?e:e.next,u===n))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;e=o;do{if(n>=e.x&&e.x>=l&&n!==e.x&&jg(s<c?n:r,s,l,c,s<c?r:n,s,e.x,e.y)){let u=Math.abs(s-e.y)/(n-e.x);la(e,i)&&(u<h||u===h&&(e.x>o.x||e.x===o.x&&$b(o,e)))&&(o=e,h=u)}e=e.next}while(e!==a);return o}function $b(i,t){return Ee(i.prev,i,t.prev)<0&&Ee(t.next,i,i.next)<0}function Xb(i,t,e,n){let s=i;do s.z===0&&(s.z=Bd(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,qb(s)}function qb(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function Bd(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function Yb(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function jg(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function ko(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&jg(i,t,e,n,s,r,o,a)}function Zb(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!jb(i,t)&&(la(i,t)&&la(t,i)&&Kb(i,t)&&(Ee(i.prev,i,t.prev)||Ee(i,t.prev,t))||Gr(i,t)&&Ee(i.prev,i,i.next)>0&&Ee(t.prev,t,t.next)>0)}function Ee(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function Gr(i,t){return i.x===t.x&&i.y===t.y}function Kg(i,t,e,n){let s=Yl(Ee(i,t,e)),r=Yl(Ee(i,t,n)),o=Yl(Ee(e,n,i)),a=Yl(Ee(e,n,t));return!!(s!==r&&o!==a||s===0&&ql(i,e,t)||r===0&&ql(i,n,t)||o===0&&ql(e,i,n)||a===0&&ql(e,t,n))}function ql(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function Yl(i){return i>0?1:i<0?-1:0}function jb(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&Kg(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function la(i,t){return Ee(i.prev,i,i.next)<0?Ee(i,t,i.next)>=0&&Ee(i,i.prev,t)>=0:Ee(i,t,i.prev)<0||Ee(i,i.next,t)<0}function Kb(i,t){let e=i,n=!1,s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function Jg(i,t){let e=zd(i.i,i.x,i.y),n=zd(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function Qm(i,t,e,n){let s=zd(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function ca(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function zd(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Jb(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var Gd=class{static triangulate(t,e,n=2){return Ob(t,e,n)}},Ar=class i{static area(t){let e=t.length,n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return i.area(t)<0}static triangulateShape(t,e){let n=[],s=[],r=[];tg(t),eg(n,t);let o=t.length;e.forEach(tg);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,eg(n,e[l]);let a=Gd.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function tg(i){let t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function eg(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}var Ns=class i extends Ft{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let v=g*d-o;for(let S=0;S<c;S++){let b=S*u-r;p.push(b,-v,0),x.push(0,0,1),m.push(S/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let S=v+c*g,b=v+c*(g+1),T=v+1+c*(g+1),R=v+1+c*g;f.push(S,b,R),f.push(b,T,R)}this.setIndex(f),this.setAttribute("position",new Vt(p,3)),this.setAttribute("normal",new Vt(x,3)),this.setAttribute("uv",new Vt(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},ks=class i extends Ft{constructor(t=.5,e=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=t,d=(e-t)/s,f=new A,p=new st;for(let x=0;x<=s;x++){for(let m=0;m<=n;m++){let g=r+m/n*o;f.x=u*Math.cos(g),f.y=u*Math.sin(g),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/e+1)/2,p.y=(f.y/e+1)/2,h.push(p.x,p.y)}u+=d}for(let x=0;x<s;x++){let m=x*(n+1);for(let g=0;g<n;g++){let v=g+m,S=v,b=v+n+1,T=v+n+2,R=v+1;a.push(S,b,R),a.push(b,T,R)}}this.setIndex(a),this.setAttribute("position",new Vt(l,3)),this.setAttribute("normal",new Vt(c,3)),this.setAttribute("uv",new Vt(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}},Os=class i extends Ft{constructor(t=new Ni([new st(0,.5),new st(-.5,-.5),new st(.5,-.5)]),e=12){super(),this.type="ShapeGeometry",this.parameters={shapes:t,curveSegments:e};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(t)===!1)c(t);else for(let h=0;h<t.length;h++)c(t[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new Vt(s,3)),this.setAttribute("normal",new Vt(r,3)),this.setAttribute("uv",new Vt(o,2));function c(h){let u=s.length/3,d=h.extractPoints(e),f=d.shape,p=d.holes;Ar.isClockWise(f)===!1&&(f=f.reverse());for(let m=0,g=p.length;m<g;m++){let v=p[m];Ar.isClockWise(v)===!0&&(p[m]=v.reverse())}let x=Ar.triangulateShape(f,p);for(let m=0,g=p.length;m<g;m++){let v=p[m];f=f.concat(v)}for(let m=0,g=f.length;m<g;m++){let v=f[m];s.push(v.x,v.y,0),r.push(0,0,1),o.push(v.x,v.y)}for(let m=0,g=x.length;m<g;m++){let v=x[m],S=v[0]+u,b=v[1]+u,T=v[2]+u;n.push(S,b,T),l+=3}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes;return Qb(e,t)}static fromJSON(t,e){let n=[];for(let s=0,r=t.shapes.length;s<r;s++){let o=e[t.shapes[s]];n.push(o)}return new i(n,t.curveSegments)}};function Qb(i,t){if(t.shapes=[],Array.isArray(i))for(let e=0,n=i.length;e<n;e++){let s=i[e];t.shapes.push(s.uuid)}else t.shapes.push(i.uuid);return t}var ki=class i extends Ft{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new A,d=new A,f=[],p=[],x=[],m=[];for(let g=0;g<=n;g++){let v=[],S=g/n,b=o+S*a,T=t*Math.cos(b),R=Math.sqrt(t*t-T*T),y=0;g===0&&o===0?y=.5/e:g===n&&l===Math.PI&&(y=-.5/e);for(let E=0;E<=e;E++){let D=E/e,P=s+D*r;u.x=-R*Math.cos(P),u.y=T,u.z=R*Math.sin(P),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),m.push(D+y,1-S),v.push(c++)}h.push(v)}for(let g=0;g<n;g++)for(let v=0;v<e;v++){let S=h[g][v+1],b=h[g][v],T=h[g+1][v],R=h[g+1][v+1];(g!==0||o>0)&&f.push(S,b,R),(g!==n-1||l<Math.PI)&&f.push(b,T,R)}this.setIndex(f),this.setAttribute("position",new Vt(p,3)),this.setAttribute("normal",new Vt(x,3)),this.setAttribute("uv",new Vt(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var ha=class extends Ft{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,s=new A,r=new A;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],d=u.start,f=u.count;for(let p=d,x=d+f;p<x;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),v=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,v),ng(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,u=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),ng(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new Vt(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function ng(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(s)===!0?!1:(e.add(n),e.add(s),!0)}var ua=class extends wn{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Mt(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function Vs(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(ig(s))s.isRenderTargetTexture?(Dt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(ig(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function hn(i){let t={};for(let e=0;e<i.length;e++){let n=Vs(i[e]);for(let s in n)t[s]=n[s]}return t}function ig(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function t_(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function wf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:se.workingColorSpace}var La={clone:Vs,merge:hn},e_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,n_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,$n=class extends wn{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=e_,this.fragmentShader=n_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Vs(t.uniforms),this.uniformsGroups=t_(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Mt().setHex(s.value);break;case"v2":this.uniforms[n].value=new st().fromArray(s.value);break;case"v3":this.uniforms[n].value=new A().fromArray(s.value);break;case"v4":this.uniforms[n].value=new pe().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Wt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Lt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Mc=class extends $n{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},da=class extends wn{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Mt(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Mt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zr,this.normalScale=new st(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ei,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var fa=class extends wn{constructor(t){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new Mt(16777215),this.specular=new Mt(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Mt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zr,this.normalScale=new st(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ei,this.combine=Sa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.specular.copy(t.specular),this.shininess=t.shininess,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Nn=class extends wn{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Mt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Mt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zr,this.normalScale=new st(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ei,this.combine=Sa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Sc=class extends wn{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=kg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Tc=class extends wn{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function br(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Zl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var os=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ec=class extends os{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:kd,endingEnd:kd}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Od:r=t,a=2*e-n;break;case Fd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Od:o=t,l=2*n-e;break;case Fd:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,v=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,S=(-1-f)*m+(1.5+f)*x+.5*p,b=f*m-f*x;for(let T=0;T!==a;++T)r[T]=g*o[h+T]+v*o[c+T]+S*o[l+T]+b*o[u+T];return r}},Ac=class extends os{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Rc=class extends os{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Cc=class extends os{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,v=u[g],S=u[g+1],b=t*d+p*2,T=h[b],R=h[b+1],y=s_(n,e,v,T,s);r[p]=Qg(y,x,S,R,m)}return r}};function Qg(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function i_(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function s_(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Qg(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=i_(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var kn=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=br(e,this.TimeBufferType),this.values=br(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:br(t.times,Array),values:br(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Zl(t.settings)&&(n.settings={inTangents:br(t.settings.inTangents,Array),outTangents:br(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Rc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Ac(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ec(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Cc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case zo:e=this.InterpolantFactoryMethodDiscrete;break;case cc:e=this.InterpolantFactoryMethodLinear;break;case Ql:e=this.InterpolantFactoryMethodSmooth;break;case Nd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Dt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return zo;case this.InterpolantFactoryMethodLinear:return cc;case this.InterpolantFactoryMethodSmooth:return Ql;case this.InterpolantFactoryMethodBezier:return Nd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Zl(this.settings)&&(sg(this.settings.inTangents,t),sg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Zl(this.settings)&&(rg(this.settings.inTangents,t),rg(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Bt("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Bt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Bt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Bt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Yv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Bt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Ql,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=e[u+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Zl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function sg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function rg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}kn.prototype.ValueTypeName="";kn.prototype.TimeBufferType=Float32Array;kn.prototype.ValueBufferType=Float32Array;kn.prototype.DefaultInterpolation=cc;var as=class extends kn{constructor(t,e,n){super(t,e,n)}};as.prototype.ValueTypeName="bool";as.prototype.ValueBufferType=Array;as.prototype.DefaultInterpolation=zo;as.prototype.InterpolantFactoryMethodLinear=void 0;as.prototype.InterpolantFactoryMethodSmooth=void 0;var Pc=class extends kn{constructor(t,e,n,s){super(t,e,n,s)}};Pc.prototype.ValueTypeName="color";var Ic=class extends kn{constructor(t,e,n,s){super(t,e,n,s)}};Ic.prototype.ValueTypeName="number";var Lc=class extends os{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Le.slerpFlat(r,0,o,c-a,o,c,l);return r}},pa=class extends kn{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Lc(this.times,this.values,this.getValueSize(),t)}};pa.prototype.ValueTypeName="quaternion";pa.prototype.InterpolantFactoryMethodSmooth=void 0;var ls=class extends kn{constructor(t,e,n){super(t,e,n)}};ls.prototype.ValueTypeName="string";ls.prototype.ValueBufferType=Array;ls.prototype.DefaultInterpolation=zo;ls.prototype.InterpolantFactoryMethodLinear=void 0;ls.prototype.InterpolantFactoryMethodSmooth=void 0;var Dc=class extends kn{constructor(t,e,n,s){super(t,e,n,s)}};Dc.prototype.ValueTypeName="vector";var Nc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},t0=new Nc,kc=class{constructor(t){this.manager=t!==void 0?t:t0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};kc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Vr=class extends De{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Mt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},ma=class extends Vr{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(De.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Mt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Ld=new Lt,og=new A,ag=new A,Oc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new st(512,512),this.mapType=Mn,this.map=null,this.mapPass=null,this.matrix=new Lt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new is,this._frameExtents=new st(1,1),this._viewportCount=1,this._viewports=[new pe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;og.setFromMatrixPosition(t.matrixWorld),e.position.copy(og),ag.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(ag),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Ld.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Ld,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Pr||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Ld)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},jl=new A,Kl=new Le,ui=new A,ga=class extends De{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Lt,this.projectionMatrix=new Lt,this.projectionMatrixInverse=new Lt,this.coordinateSystem=Hn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(jl,Kl,ui),ui.x===1&&ui.y===1&&ui.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Kl,ui.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(jl,Kl,ui),ui.x===1&&ui.y===1&&ui.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Kl,ui.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ns=new A,lg=new st,cg=new st,fn=class extends ga{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Lr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Tr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Lr*2*Math.atan(Math.tan(Tr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ns.x,ns.y).multiplyScalar(-t/ns.z),ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ns.x,ns.y).multiplyScalar(-t/ns.z)}getViewSize(t,e){return this.getViewBounds(t,lg,cg),e.subVectors(cg,lg)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Tr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var xa=class extends ga{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Vd=class extends Oc{constructor(){super(new xa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ya=class extends Vr{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(De.DEFAULT_UP),this.updateMatrix(),this.target=new De,this.shadow=new Vd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},va=class extends Vr{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var ba=class extends Ft{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var _r=-90,wr=1,Hr=class extends De{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new fn(_r,wr,t,e);s.layers=this.layers,this.add(s);let r=new fn(_r,wr,t,e);r.layers=this.layers,this.add(r);let o=new fn(_r,wr,t,e);o.layers=this.layers,this.add(o);let a=new fn(_r,wr,t,e);a.layers=this.layers,this.add(a);let l=new fn(_r,wr,t,e);l.layers=this.layers,this.add(l);let c=new fn(_r,wr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Hn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Pr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Fc=class extends fn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Mf="\\[\\]\\.:\\/",r_=new RegExp("["+Mf+"]","g"),Sf="[^"+Mf+"]",o_="[^"+Mf.replace("\\.","")+"]",a_=/((?:WC+[\/:])*)/.source.replace("WC",Sf),l_=/(WCOD+)?/.source.replace("WCOD",o_),c_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Sf),h_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Sf),u_=new RegExp("^"+a_+l_+c_+h_+"$"),d_=["material","materials","bones","map"],Hd=class{constructor(t,e,n){let s=n||_e.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},_e=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(r_,"")}static parseTrackName(t){let e=u_.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);d_.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Dt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){Bt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Bt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Bt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Bt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Bt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Bt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){Bt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Bt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Bt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Bt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};_e.Composite=Hd;_e.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};_e.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};_e.prototype.GetterByBindingType=[_e.prototype._getValue_direct,_e.prototype._getValue_array,_e.prototype._getValue_arrayElement,_e.prototype._getValue_toArray];_e.prototype.SetterByBindingTypeAndVersioning=[[_e.prototype._setValue_direct,_e.prototype._setValue_direct_setNeedsUpdate,_e.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_array,_e.prototype._setValue_array_setNeedsUpdate,_e.prototype._setValue_array_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_arrayElement,_e.prototype._setValue_arrayElement_setNeedsUpdate,_e.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_fromArray,_e.prototype._setValue_fromArray_setNeedsUpdate,_e.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var EC=new Float32Array(1);var mi=class extends kr{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var Wr=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Ht(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(Ht(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Wd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var hg=new A,Jl=new A,Mr=new A,Sr=new A,Dd=new A,f_=new A,p_=new A,_a=class{constructor(t=new A,e=new A){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){hg.subVectors(t,this.start),Jl.subVectors(this.end,this.start);let n=Jl.dot(Jl);if(n===0)return 0;let r=Jl.dot(hg)/n;return e&&(r=Ht(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=f_,n=p_){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,h=t.end;Mr.subVectors(c,a),Sr.subVectors(h,l),Dd.subVectors(a,l);let u=Mr.dot(Mr),d=Sr.dot(Sr),f=Sr.dot(Dd);if(u<=s&&d<=s)return e.copy(a),n.copy(l),e.distanceToSquared(n);if(u<=s)r=0,o=f/d,o=Ht(o,0,1);else{let p=Mr.dot(Dd);if(d<=s)o=0,r=Ht(-p/u,0,1);else{let x=Mr.dot(Sr),m=u*d-x*x;m!==0?r=Ht((x*f-p*d)/m,0,1):r=0,o=(x*r+f)/d,o<0?(o=0,r=Ht(-p/u,0,1)):o>1&&(o=1,r=Ht((x-p)/u,0,1))}}return e.copy(a).addScaledVector(Mr,r),n.copy(l).addScaledVector(Sr,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var wa=class extends Br{constructor(t=10,e=10,n=4473924,s=8947848){n=new Mt(n),s=new Mt(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let d=0,f=0,p=-a;d<=e;d++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let x=d===r?n:s;x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3}let h=new Ft;h.setAttribute("position",new Vt(l,3)),h.setAttribute("color",new Vt(c,3));let u=new Ps({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ma=class extends ti{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Tf(i,t,e,n){let s=m_(n);switch(e){case hf:return i*t;case Wc:return i*t/s.components*s.byteLength;case $c:return i*t/s.components*s.byteLength;case ds:return i*t*2/s.components*s.byteLength;case Xc:return i*t*2/s.components*s.byteLength;case uf:return i*t*3/s.components*s.byteLength;case ri:return i*t*4/s.components*s.byteLength;case qc:return i*t*4/s.components*s.byteLength;case Ea:case Aa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ra:case Ca:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Zc:case Kc:return Math.max(i,16)*Math.max(t,8)/4;case Yc:case jc:return Math.max(i,8)*Math.max(t,8)/2;case Jc:case Qc:case eh:case nh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case th:case Pa:case ih:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case sh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case rh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case oh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case ah:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case lh:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case ch:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case hh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case uh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case dh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case fh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case ph:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case mh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case gh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case xh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case yh:case vh:case bh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case _h:case wh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ia:case Mh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function m_(i){switch(i){case Mn:case of:return{byteLength:1,components:1};case Yr:case af:case si:return{byteLength:2,components:1};case Vc:case Hc:return{byteLength:2,components:4};case ii:case Gc:case Xn:return{byteLength:4,components:1};case lf:case cf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Dt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function w0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function b_(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var __=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,w_=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,M_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,S_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,T_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,E_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,A_=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,R_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,C_=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,P_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,I_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,L_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,D_=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,N_=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,k_=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,O_=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,F_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,U_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,B_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,z_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,G_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,V_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,H_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,W_=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,$_=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,X_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,q_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Y_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Z_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,j_="gl_FragColor = linearToOutputTexel( gl_FragColor );",K_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,J_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Q_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,tw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,ew=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,nw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,iw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,sw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,rw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ow=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,aw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,lw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,cw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,hw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,uw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,dw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,fw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,pw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,mw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,xw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,yw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,vw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,bw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,_w=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,ww=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Mw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Sw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Tw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ew=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Aw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Rw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Cw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Pw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Iw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Lw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Dw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Nw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,kw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ow=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Fw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Uw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Bw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,zw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Vw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Hw=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Ww=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,$w=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Xw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,qw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Yw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Zw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,jw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Kw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Jw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Qw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,tM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,eM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,iM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,sM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,rM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,oM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,aM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,lM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,hM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,uM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,dM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,fM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,pM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,mM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,gM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,yM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,vM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,bM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,_M=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,MM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,TM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,EM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,AM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,RM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,CM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,PM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,IM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,DM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,NM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,kM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,OM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,FM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,BM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,GM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,VM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,HM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,WM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,$M=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,qM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,YM=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,ZM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,jM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,KM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,JM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,QM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Jt={alphahash_fragment:__,alphahash_pars_fragment:w_,alphamap_fragment:M_,alphamap_pars_fragment:S_,alphatest_fragment:T_,alphatest_pars_fragment:E_,aomap_fragment:A_,aomap_pars_fragment:R_,batching_pars_vertex:C_,batching_vertex:P_,begin_vertex:I_,beginnormal_vertex:L_,bsdfs:D_,iridescence_fragment:N_,bumpmap_pars_fragment:k_,clipping_planes_fragment:O_,clipping_planes_pars_fragment:F_,clipping_planes_pars_vertex:U_,clipping_planes_vertex:B_,color_fragment:z_,color_pars_fragment:G_,color_pars_vertex:V_,color_vertex:H_,common:W_,defaultnormal_vertex:$_,displacementmap_pars_vertex:X_,displacementmap_vertex:q_,emissivemap_fragment:Y_,emissivemap_pars_fragment:Z_,colorspace_fragment:j_,colorspace_pars_fragment:K_,envmap_fragment:J_,envmap_common_pars_fragment:Q_,envmap_pars_fragment:tw,envmap_pars_vertex:ew,envmap_physical_pars_fragment:dw,envmap_vertex:nw,fog_vertex:iw,fog_pars_vertex:sw,fog_fragment:rw,fog_pars_fragment:ow,gradientmap_pars_fragment:aw,lightmap_pars_fragment:lw,lights_lambert_fragment:cw,lights_lambert_pars_fragment:hw,lights_pars_begin:uw,lights_toon_fragment:fw,lights_toon_pars_fragment:pw,lights_phong_fragment:mw,lights_phong_pars_fragment:gw,lights_physical_fragment:xw,lights_physical_pars_fragment:yw,lights_fragment_begin:vw,lights_fragment_maps:bw,lights_fragment_end:_w,lightprobes_pars_fragment:ww,logdepthbuf_fragment:Mw,logdepthbuf_pars_fragment:Sw,logdepthbuf_pars_vertex:Tw,logdepthbuf_vertex:Ew,map_fragment:Aw,map_pars_fragment:Rw,map_particle_fragment:Cw,map_particle_pars_fragment:Pw,metalnessmap_fragment:Iw,metalnessmap_pars_fragment:Lw,morphinstance_vertex:Dw,morphcolor_vertex:Nw,morphnormal_vertex:kw,morphtarget_pars_vertex:Ow,morphtarget_vertex:Fw,normal_fragment_begin:Uw,normal_fragment_maps:Bw,normal_pars_fragment:zw,normal_pars_vertex:Gw,normal_vertex:Vw,normalmap_pars_fragment:Hw,clearcoat_normal_fragment_begin:Ww,clearcoat_normal_fragment_maps:$w,clearcoat_pars_fragment:Xw,iridescence_pars_fragment:qw,opaque_fragment:Yw,packing:Zw,premultiplied_alpha_fragment:jw,project_vertex:Kw,dithering_fragment:Jw,dithering_pars_fragment:Qw,roughnessmap_fragment:tM,roughnessmap_pars_fragment:eM,shadowmap_pars_fragment:nM,shadowmap_pars_vertex:iM,shadowmap_vertex:sM,shadowmask_pars_fragment:rM,skinbase_vertex:oM,skinning_pars_vertex:aM,skinning_vertex:lM,skinnormal_vertex:cM,specularmap_fragment:hM,specularmap_pars_fragment:uM,tonemapping_fragment:dM,tonemapping_pars_fragment:fM,transmission_fragment:pM,transmission_pars_fragment:mM,uv_pars_fragment:gM,uv_pars_vertex:xM,uv_vertex:yM,worldpos_vertex:vM,background_vert:bM,background_frag:_M,backgroundCube_vert:wM,backgroundCube_frag:MM,cube_vert:SM,cube_frag:TM,depth_vert:EM,depth_frag:AM,distance_vert:RM,distance_frag:CM,equirect_vert:PM,equirect_frag:IM,linedashed_vert:LM,linedashed_frag:DM,meshbasic_vert:NM,meshbasic_frag:kM,meshlambert_vert:OM,meshlambert_frag:FM,meshmatcap_vert:UM,meshmatcap_frag:BM,meshnormal_vert:zM,meshnormal_frag:GM,meshphong_vert:VM,meshphong_frag:HM,meshphysical_vert:WM,meshphysical_frag:$M,meshtoon_vert:XM,meshtoon_frag:qM,points_vert:YM,points_frag:ZM,shadow_vert:jM,shadow_frag:KM,sprite_vert:JM,sprite_frag:QM},pt={common:{diffuse:{value:new Mt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Wt},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Wt}},envmap:{envMap:{value:null},envMapRotation:{value:new Wt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Wt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Wt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Wt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Wt},normalScale:{value:new st(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Wt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Wt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Wt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Wt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Mt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Mt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0},uvTransform:{value:new Wt}},sprite:{diffuse:{value:new Mt(16777215)},opacity:{value:1},center:{value:new st(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Wt},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0}}},xn={basic:{uniforms:hn([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.fog]),vertexShader:Jt.meshbasic_vert,fragmentShader:Jt.meshbasic_frag},lambert:{uniforms:hn([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,pt.lights,{emissive:{value:new Mt(0)},envMapIntensity:{value:1}}]),vertexShader:Jt.meshlambert_vert,fragmentShader:Jt.meshlambert_frag},phong:{uniforms:hn([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,pt.lights,{emissive:{value:new Mt(0)},specular:{value:new Mt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Jt.meshphong_vert,fragmentShader:Jt.meshphong_frag},standard:{uniforms:hn([pt.common,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.roughnessmap,pt.metalnessmap,pt.fog,pt.lights,{emissive:{value:new Mt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Jt.meshphysical_vert,fragmentShader:Jt.meshphysical_frag},toon:{uniforms:hn([pt.common,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.gradientmap,pt.fog,pt.lights,{emissive:{value:new Mt(0)}}]),vertexShader:Jt.meshtoon_vert,fragmentShader:Jt.meshtoon_frag},matcap:{uniforms:hn([pt.common,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,{matcap:{value:null}}]),vertexShader:Jt.meshmatcap_vert,fragmentShader:Jt.meshmatcap_frag},points:{uniforms:hn([pt.points,pt.fog]),vertexShader:Jt.points_vert,fragmentShader:Jt.points_frag},dashed:{uniforms:hn([pt.common,pt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Jt.linedashed_vert,fragmentShader:Jt.linedashed_frag},depth:{uniforms:hn([pt.common,pt.displacementmap]),vertexShader:Jt.depth_vert,fragmentShader:Jt.depth_frag},normal:{uniforms:hn([pt.common,pt.bumpmap,pt.normalmap,pt.displacementmap,{opacity:{value:1}}]),vertexShader:Jt.meshnormal_vert,fragmentShader:Jt.meshnormal_frag},sprite:{uniforms:hn([pt.sprite,pt.fog]),vertexShader:Jt.sprite_vert,fragmentShader:Jt.sprite_frag},background:{uniforms:{uvTransform:{value:new Wt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Jt.background_vert,fragmentShader:Jt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Wt}},vertexShader:Jt.backgroundCube_vert,fragmentShader:Jt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Jt.cube_vert,fragmentShader:Jt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Jt.equirect_vert,fragmentShader:Jt.equirect_frag},distance:{uniforms:hn([pt.common,pt.displacementmap,{referencePosition:{value:new A},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Jt.distance_vert,fragmentShader:Jt.distance_frag},shadow:{uniforms:hn([pt.lights,pt.fog,{color:{value:new Mt(0)},opacity:{value:1}}]),vertexShader:Jt.shadow_vert,fragmentShader:Jt.shadow_frag}};xn.physical={uniforms:hn([xn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Wt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Wt},clearcoatNormalScale:{value:new st(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Wt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Wt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Wt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Wt},sheen:{value:0},sheenColor:{value:new Mt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Wt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Wt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Wt},transmissionSamplerSize:{value:new st},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Wt},attenuationDistance:{value:0},attenuationColor:{value:new Mt(0)},specularColor:{value:new Mt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Wt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Wt},anisotropyVector:{value:new st},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Wt}}]),vertexShader:Jt.meshphysical_vert,fragmentShader:Jt.meshphysical_frag};var Th={r:0,b:0,g:0},tS=new Lt,M0=new Wt;M0.set(-1,0,0,0,1,0,0,0,1);function eS(i,t,e,n,s,r){let o=new Mt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let S=v.isScene===!0?v.background:null;if(S&&S.isTexture){let b=v.backgroundBlurriness>0;S=t.get(S,b)}return S}function p(v){let S=!1,b=f(v);b===null?m(o,a):b&&b.isColor&&(m(b,1),S=!0);let T=i.xr.getEnvironmentBlendMode();T==="additive"?e.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(v,S){let b=f(S);b&&b.isCubeTexture?(c===void 0&&(c=new ae(new Ln(1,1,1),new $n({name:"BackgroundCubeMaterial",uniforms:Vs(xn.backgroundCube.uniforms),vertexShader:xn.backgroundCube.vertexShader,fragmentShader:xn.backgroundCube.fragmentShader,side:gn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,R,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(tS.makeRotationFromEuler(S.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(M0),c.material.toneMapped=se.getTransfer(b.colorSpace)!==fe,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new ae(new Ns(2,2),new $n({name:"BackgroundMaterial",uniforms:Vs(xn.background.uniforms),vertexShader:xn.background.vertexShader,fragmentShader:xn.background.fragmentShader,side:us,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=se.getTransfer(b.colorSpace)!==fe,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,S){v.getRGB(Th,wf(i)),e.buffers.color.setClear(Th.r,Th.g,Th.b,S,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,S=1){o.set(v),a=S,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:p,addToRenderList:x,dispose:g}}function nS(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(k,O,B,I,V){let X=!1,H=u(k,I,B,O);r!==H&&(r=H,c(r.object)),X=f(k,I,B,V),X&&p(k,I,B,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,b(k,O,B,I),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(k){return i.bindVertexArray(k)}function h(k){return i.deleteVertexArray(k)}function u(k,O,B,I){let V=I.wireframe===!0,X=n[O.id];X===void 0&&(X={},n[O.id]=X);let H=k.isInstancedMesh===!0?k.id:0,et=X[H];et===void 0&&(et={},X[H]=et);let $=et[B.id];$===void 0&&($={},et[B.id]=$);let J=$[V];return J===void 0&&(J=d(l()),$[V]=J),J}function d(k){let O=[],B=[],I=[];for(let V=0;V<e;V++)O[V]=0,B[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:B,attributeDivisors:I,object:k,attributes:{},index:null}}function f(k,O,B,I){let V=r.attributes,X=O.attributes,H=0,et=B.getAttributes();for(let $ in et)if(et[$].location>=0){let tt=V[$],wt=X[$];if(wt===void 0&&($==="instanceMatrix"&&k.instanceMatrix&&(wt=k.instanceMatrix),$==="instanceColor"&&k.instanceColor&&(wt=k.instanceColor)),tt===void 0||tt.attribute!==wt||wt&&tt.data!==wt.data)return!0;H++}return r.attributesNum!==H||r.index!==I}function p(k,O,B,I){let V={},X=O.attributes,H=0,et=B.getAttributes();for(let $ in et)if(et[$].location>=0){let tt=X[$];tt===void 0&&($==="instanceMatrix"&&k.instanceMatrix&&(tt=k.instanceMatrix),$==="instanceColor"&&k.instanceColor&&(tt=k.instanceColor));let wt={};wt.attribute=tt,tt&&tt.data&&(wt.data=tt.data),V[$]=wt,H++}r.attributes=V,r.attributesNum=H,r.index=I}function x(){let k=r.newAttributes;for(let O=0,B=k.length;O<B;O++)k[O]=0}function m(k){g(k,0)}function g(k,O){let B=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;B[k]=1,I[k]===0&&(i.enableVertexAttribArray(k),I[k]=1),V[k]!==O&&(i.vertexAttribDivisor(k,O),V[k]=O)}function v(){let k=r.newAttributes,O=r.enabledAttributes;for(let B=0,I=O.length;B<I;B++)O[B]!==k[B]&&(i.disableVertexAttribArray(B),O[B]=0)}function S(k,O,B,I,V,X,H){H===!0?i.vertexAttribIPointer(k,O,B,V,X):i.vertexAttribPointer(k,O,B,I,V,X)}function b(k,O,B,I){x();let V=I.attributes,X=B.getAttributes(),H=O.defaultAttributeValues;for(let et in X){let $=X[et];if($.location>=0){let J=V[et];if(J===void 0&&(et==="instanceMatrix"&&k.instanceMatrix&&(J=k.instanceMatrix),et==="instanceColor"&&k.instanceColor&&(J=k.instanceColor)),J!==void 0){let tt=J.normalized,wt=J.itemSize,Nt=t.get(J);if(Nt===void 0)continue;let Z=Nt.buffer,yt=Nt.type,Tt=Nt.bytesPerElement,kt=yt===i.INT||yt===i.UNSIGNED_INT||J.gpuType===Gc;if(J.isInterleavedBufferAttribute){let vt=J.data,Yt=vt.isInterleavedBuffer===!0?vt.stride:vt.itemSize,Ae=J.offset;if(vt.isInstancedInterleavedBuffer||vt.isInstancedBufferAttribute){for(let Ut=0;Ut<$.locationSize;Ut++)g($.location+Ut,vt.meshPerAttribute);k.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=vt.meshPerAttribute*vt.count)}else for(let Ut=0;Ut<$.locationSize;Ut++)m($.location+Ut);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let Ut=0;Ut<$.locationSize;Ut++)S($.location+Ut,wt/$.locationSize,yt,tt,Yt*Tt,(Ae+wt/$.locationSize*Ut)*Tt,kt)}else{if(J.isInstancedBufferAttribute){for(let vt=0;vt<$.locationSize;vt++)g($.location+vt,J.meshPerAttribute);k.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let vt=0;vt<$.locationSize;vt++)m($.location+vt);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let vt=0;vt<$.locationSize;vt++)S($.location+vt,wt/$.locationSize,yt,tt,wt*Tt,wt/$.locationSize*vt*Tt,kt)}}else if(H!==void 0){let tt=H[et];if(tt!==void 0)switch(tt.length){case 2:i.vertexAttrib2fv($.location,tt);break;case 3:i.vertexAttrib3fv($.location,tt);break;case 4:i.vertexAttrib4fv($.location,tt);break;default:i.vertexAttrib1fv($.location,tt)}}}}v()}function T(){D();for(let k in n){let O=n[k];for(let B in O){let I=O[B];for(let V in I){let X=I[V];for(let H in X)h(X[H].object),delete X[H];delete I[V]}}delete n[k]}}function R(k){if(n[k.id]===void 0)return;let O=n[k.id];for(let B in O){let I=O[B];for(let V in I){let X=I[V];for(let H in X)h(X[H].object),delete X[H];delete I[V]}}delete n[k.id]}function y(k){for(let O in n){let B=n[O];for(let I in B){let V=B[I];if(V[k.id]===void 0)continue;let X=V[k.id];for(let H in X)h(X[H].object),delete X[H];delete V[k.id]}}}function E(k){for(let O in n){let B=n[O],I=k.isInstancedMesh===!0?k.id:0,V=B[I];if(V!==void 0){for(let X in V){let H=V[X];for(let et in H)h(H[et].object),delete H[et];delete V[X]}delete B[I],Object.keys(B).length===0&&delete n[O]}}}function D(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:P,dispose:T,releaseStatesOfGeometry:R,releaseStatesOfObject:E,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:m,disableUnusedAttributes:v}}function iS(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function sS(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==ri&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let E=y===si&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Mn&&y!==Xn&&!E&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Dt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Dt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Dt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),T=i.getParameter(i.MAX_SAMPLES),R=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:v,maxVaryings:S,maxFragmentUniforms:b,maxSamples:T,samples:R}}function rS(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Pn,a=new Wt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let v=r?0:n,S=v*4,b=g.clippingState||null;l.value=b,b=h(p,d,S,f);for(let T=0;T!==S;++T)b[T]=e[T];g.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<g)&&(m=new Float32Array(g));for(let S=0,b=f;S!==x;++S,b+=4)o.copy(u[S]).applyMatrix4(v,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var ka=class extends In{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Jo(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ln(5,5,5),r=new $n({name:"CubemapFromEquirect",uniforms:Vs(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:gn,blending:Us});r.uniforms.tEquirect.value=e;let o=new ae(s,r),a=e.minFilter;return e.minFilter===Oi&&(e.minFilter=pn),new Hr(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},e0=256,oS=3,aS=20,S0=256,T0=16,lS=3,cS=new A,hS=new Mt,Ah=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Hr(1,10,null),this._boxMesh=new ae(new Ln(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=cS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(hS));let m=new Hr(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=s0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=i0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(e0,yf(t))}_fromTexture(t,e){t.mapping===zs||t.mapping===qr?this._setSize(t.image.length===0?e0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=n0(t,!1,!1),n=Math.log2(t)-oS;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=n0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===zs||t.mapping===qr?(this._cubemapMaterial===null&&(this._cubemapMaterial=s0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=i0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=uS(),this._integrationMaterial=dS());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/T0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-lS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(S0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=fS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function n0(i,t,e){return new ka(i,{minFilter:Oi,generateMipmaps:t,type:si,colorSpace:Go,depthBuffer:e})}function Oa(i,t,e){return new $n({name:i,uniforms:t,vertexShader:Jt.cube_vert,fragmentShader:e,side:gn,blending:Us,depthTest:!1,depthWrite:!1})}function uS(){return Oa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${S0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function dS(){return Oa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:T0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function fS(){return Oa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${aS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function i0(){return Oa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function s0(){return Oa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function pS(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Uc||f===Bc)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new ka(p.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Uc||f===Bc,x=f===zs||f===qr;if(p||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new Ah(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let v=d.image;return p&&v&&v.height>0||x&&v&&l(v)?(n===null&&(n=new Ah(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Uc?d.mapping=zs:f===Bc&&(d.mapping=qr),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function mS(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Oo("WebGLRenderer: "+n+" extension not supported."),s}}}function gS(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)t.update(x[m],i.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let v=x!==null?x.array.length:m.array.length/3-1,S=m.count>=65535?Zo:Yo,b=new S(Math.ceil(v/3)*6,1),T=b.array;if(x!==null){let y=x.array;g=x.version;for(let E=0,D=0;E<v;E+=3){let P=y[E+0],k=y[E+1],O=y[E+2];T[D++]=P,T[D++]=k,T[D++]=k,T[D++]=O,T[D++]=O,T[D++]=P}}else{g=m.version;for(let y=0,E=0;y<v;y+=3){let D=y+0,P=y+1,k=y+2;T[E++]=D,T[E++]=P,T[E++]=P,T[E++]=k,T[E++]=k,T[E++]=D}}b.version=g;let R=r.get(p);R&&t.remove(R),r.set(p,b)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function xS(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function yS(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:Bt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function vS(i,t,e){let n=new WeakMap,s=new pe;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let D=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],S=0;f===!0&&(S=1),p===!0&&(S=2),x===!0&&(S=3);let b=a.attributes.position.count*S,T=1;b>t.maxTextureSize&&(T=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let R=new Float32Array(b*T*4*u),y=new $o(R,b,T,u);y.type=Xn,y.needsUpdate=!0;let E=S*4;for(let P=0;P<u;P++){let k=m[P],O=g[P],B=v[P],I=b*T*4*P;for(let V=0;V<k.count;V++){let X=V*E;f===!0&&(s.fromBufferAttribute(k,V),R[I+X+0]=s.x,R[I+X+1]=s.y,R[I+X+2]=s.z,R[I+X+3]=0),p===!0&&(s.fromBufferAttribute(O,V),R[I+X+4]=s.x,R[I+X+5]=s.y,R[I+X+6]=s.z,R[I+X+7]=0),x===!0&&(s.fromBufferAttribute(B,V),R[I+X+8]=s.x,R[I+X+9]=s.y,R[I+X+10]=s.z,R[I+X+11]=B.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new st(b,T)},n.set(a,d),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function bS(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var _S={[Kd]:"LINEAR_TONE_MAPPING",[Jd]:"REINHARD_TONE_MAPPING",[Qd]:"CINEON_TONE_MAPPING",[tf]:"ACES_FILMIC_TONE_MAPPING",[nf]:"AGX_TONE_MAPPING",[sf]:"NEUTRAL_TONE_MAPPING",[ef]:"CUSTOM_TONE_MAPPING"};function wS(i,t,e,n,s,r){let o=new In(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Ft;h.setAttribute("position",new Vt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Vt([0,2,0,0,2,0],2));let u=new Mc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new ae(h,u),f=new xa(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,v=null,S=[],b=!1;this.setSize=function(T,R){o.setSize(T,R),a!==null&&a.setSize(T,R),l!==null&&l.setSize(T,R);for(let y=0;y<S.length;y++){let E=S[y];E.setSize&&E.setSize(T,R)}},this.setEffects=function(T){S=T,b=S.length>0&&S[0].isRenderPass===!0;let R=o.width,y=o.height;S.length>0&&a===null&&(a=new In(R,y,{type:si,depthBuffer:!1,stencilBuffer:!1}),l=new In(R,y,{type:si,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&S.some(D=>D.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Di(R,y),r===!0&&(c.format=Fi,c.type=Gs)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let D=0;D<S.length;D++){let P=S[D];P.setSize&&P.setSize(R,y),E&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(T,R){if(m||T.toneMapping===gi&&S.length===0)return!1;if(v=R,R!==null){let y=R.width,E=R.height;(o.width!==y||o.height!==E)&&this.setSize(y,E)}return b===!1&&T.setRenderTarget(o),g=T.toneMapping,T.toneMapping=gi,!0},this.hasRenderPass=function(){return b},this.end=function(T,R){T.toneMapping=g,m=!0;let y=o,E=a;for(let D=0;D<S.length;D++){let P=S[D];P.enabled!==!1&&(P.render(T,E,y,R),P.needsSwap!==!1&&(y=E,E=E===a?l:a))}if(p!==T.outputColorSpace||x!==T.toneMapping){p=T.outputColorSpace,x=T.toneMapping,u.defines={},se.getTransfer(p)===fe&&(u.defines.SRGB_TRANSFER="");let D=_S[x];D&&(u.defines[D]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,T.setRenderTarget(v),T.render(d,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var E0=new mn,A0=new Di(1,1),R0=new Qo(1),C0=new $o,P0=new dc,I0=new Jo,r0=[],o0=[],a0=new Float32Array(16),l0=new Float32Array(9),c0=new Float32Array(4);function Jr(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=r0[s];if(r===void 0&&(r=new Float32Array(s),r0[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function ke(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Oe(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Ch(i,t){let e=o0[t];e===void 0&&(e=new Int32Array(t),o0[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function MS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function SS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ke(e,t))return;i.uniform2fv(this.addr,t),Oe(e,t)}}function TS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(ke(e,t))return;i.uniform3fv(this.addr,t),Oe(e,t)}}function ES(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ke(e,t))return;i.uniform4fv(this.addr,t),Oe(e,t)}}function AS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ke(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Oe(e,t)}else{if(ke(e,n))return;c0.set(n),i.uniformMatrix2fv(this.addr,!1,c0),Oe(e,n)}}function RS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ke(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Oe(e,t)}else{if(ke(e,n))return;l0.set(n),i.uniformMatrix3fv(this.addr,!1,l0),Oe(e,n)}}function CS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ke(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Oe(e,t)}else{if(ke(e,n))return;a0.set(n),i.uniformMatrix4fv(this.addr,!1,a0),Oe(e,n)}}function PS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function IS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ke(e,t))return;i.uniform2iv(this.addr,t),Oe(e,t)}}function LS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ke(e,t))return;i.uniform3iv(this.addr,t),Oe(e,t)}}function DS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ke(e,t))return;i.uniform4iv(this.addr,t),Oe(e,t)}}function NS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function kS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ke(e,t))return;i.uniform2uiv(this.addr,t),Oe(e,t)}}function OS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ke(e,t))return;i.uniform3uiv(this.addr,t),Oe(e,t)}}function FS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ke(e,t))return;i.uniform4uiv(this.addr,t),Oe(e,t)}}function Ph(i){return i.version===0&&(i.compareFunction=pf,i.needsUpdate=!0),i}function US(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Ph(A0):r=E0,e.setTexture2D(t||r,s)}function BS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||P0,s)}function zS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Ph(R0):r=I0,e.setTextureCube(t||r,s)}function GS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||C0,s)}function VS(i){switch(i){case 5126:return MS;case 35664:return SS;case 35665:return TS;case 35666:return ES;case 35674:return AS;case 35675:return RS;case 35676:return CS;case 5124:case 35670:return PS;case 35667:case 35671:return IS;case 35668:case 35672:return LS;case 35669:case 35673:return DS;case 5125:return NS;case 36294:return kS;case 36295:return OS;case 36296:return FS;case 35678:case 36198:case 36298:case 36306:case 35682:return US;case 35679:case 36299:case 36307:return BS;case 35680:case 36300:case 36308:case 36293:return zS;case 36289:case 36303:case 36311:case 36292:return GS}}function HS(i,t){i.uniform1fv(this.addr,t)}function WS(i,t){let e=Jr(t,this.size,2);i.uniform2fv(this.addr,e)}function $S(i,t){let e=Jr(t,this.size,3);i.uniform3fv(this.addr,e)}function XS(i,t){let e=Jr(t,this.size,4);i.uniform4fv(this.addr,e)}function qS(i,t){let e=Jr(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function YS(i,t){let e=Jr(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function ZS(i,t){let e=Jr(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function jS(i,t){i.uniform1iv(this.addr,t)}function KS(i,t){i.uniform2iv(this.addr,t)}function JS(i,t){i.uniform3iv(this.addr,t)}function QS(i,t){i.uniform4iv(this.addr,t)}function t1(i,t){i.uniform1uiv(this.addr,t)}function e1(i,t){i.uniform2uiv(this.addr,t)}function n1(i,t){i.uniform3uiv(this.addr,t)}function i1(i,t){i.uniform4uiv(this.addr,t)}function s1(i,t,e){let n=this.cache,s=t.length,r=Ch(e,s);ke(n,r)||(i.uniform1iv(this.addr,r),Oe(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Ph(A0):o=E0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function r1(i,t,e){let n=this.cache,s=t.length,r=Ch(e,s);ke(n,r)||(i.uniform1iv(this.addr,r),Oe(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||P0,r[o])}function o1(i,t,e){let n=this.cache,s=t.length,r=Ch(e,s);ke(n,r)||(i.uniform1iv(this.addr,r),Oe(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Ph(R0):o=I0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function a1(i,t,e){let n=this.cache,s=t.length,r=Ch(e,s);ke(n,r)||(i.uniform1iv(this.addr,r),Oe(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||C0,r[o])}function l1(i){switch(i){case 5126:return HS;case 35664:return WS;case 35665:return $S;case 35666:return XS;case 35674:return qS;case 35675:return YS;case 35676:return ZS;case 5124:case 35670:return jS;case 35667:case 35671:return KS;case 35668:case 35672:return JS;case 35669:case 35673:return QS;case 5125:return t1;case 36294:return e1;case 36295:return n1;case 36296:return i1;case 35678:case 36198:case 36298:case 36306:case 35682:return s1;case 35679:case 36299:case 36307:return r1;case 35680:case 36300:case 36308:case 36293:return o1;case 36289:case 36303:case 36311:case 36292:return a1}}var Rf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=VS(e.type)}},Cf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=l1(e.type)}},Pf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Ef=/(\w+)(\])?(\[|\.)?/g;function h0(i,t){i.seq.push(t),i.map[t.id]=t}function c1(i,t,e){let n=i.name,s=n.length;for(Ef.lastIndex=0;;){let r=Ef.exec(n),o=Ef.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){h0(e,c===void 0?new Rf(a,i,t):new Cf(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new Pf(a),h0(e,u)),e=u}}}var Kr=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);c1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function u0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var h1=37297,u1=0;function d1(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var d0=new Wt;function f1(i){se._getMatrix(d0,se.workingColorSpace,i);let t=`mat3( ${d0.elements.map(e=>e.toFixed(4))} )`;switch(se.getTransfer(i)){case Vo:return[t,"LinearTransferOETF"];case fe:return[t,"sRGBTransferOETF"];default:return Dt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function f0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+d1(i.getShaderSource(t),a)}else return r}function p1(i,t){let e=f1(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var m1={[Kd]:"Linear",[Jd]:"Reinhard",[Qd]:"Cineon",[tf]:"ACESFilmic",[nf]:"AgX",[sf]:"Neutral",[ef]:"Custom"};function g1(i,t){let e=m1[t];return e===void 0?(Dt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Eh=new A;function x1(){se.getLuminanceCoefficients(Eh);let i=Eh.x.toFixed(4),t=Eh.y.toFixed(4),e=Eh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function y1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Na).join(`
`)}function v1(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function b1(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Na(i){return i!==""}function p0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function m0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var _1=/^[ \t]*#include +<([\w\d./]+)>/gm;function If(i){return i.replace(_1,w1)}function w1(i,t){let e=Jt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return If(e)}var M1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function g0(i){return i.replace(M1,S1)}function S1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function x0(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var T1={[Fs]:"SHADOWMAP_TYPE_PCF",[$r]:"SHADOWMAP_TYPE_VSM"};function E1(i){return T1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var A1={[qr]:"ENVMAP_MODE_REFRACTION"};function R1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":A1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var C1={[Sa]:"ENVMAP_BLENDING_MULTIPLY",[Lg]:"ENVMAP_BLENDING_MIX",[Dg]:"ENVMAP_BLENDING_ADD"};function P1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":C1[i.combine]||"ENVMAP_BLENDING_NONE"}function I1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=E1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=R1(e),u=P1(e),d=y1(e),f=v1(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Na).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Na).join(`
`),m.length>0&&(m+=`
`)):(x=[x0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Na).join(`
`),m=[x0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==gi?"#define TONE_MAPPING":"",e.toneMapping!==gi?Jt.tonemapping_pars_fragment:"",e.toneMapping!==gi?g1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Jt.colorspace_pars_fragment,p1("linearToOutputTexel",e.outputColorSpace),x1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Na).join(`
`)),o=If(o),o=p0(o,e),o=m0(o,e),a=If(a),a=p0(a,e),a=m0(a,e),o=g0(o),a=g0(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===gf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===gf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=g+x+o,S=g+m+a,b=u0(s,s.VERTEX_SHADER,v),T=u0(s,s.FRAGMENT_SHADER,S);s.attachShader(p,b),s.attachShader(p,T),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function R(P){if(i.debug.checkShaderErrors){let k=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(b)||"",B=s.getShaderInfoLog(T)||"",I=k.trim(),V=O.trim(),X=B.trim(),H=!0,et=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,T);else{let $=f0(s,b,"vertex"),J=f0(s,T,"fragment");Bt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+I+`
`+$+`
`+J)}else I!==""?Dt("WebGLProgram: Program Info Log:",I):(V===""||X==="")&&(et=!1);et&&(P.diagnostics={runnable:H,programLog:I,vertexShader:{log:V,prefix:x},fragmentShader:{log:X,prefix:m}})}s.deleteShader(b),s.deleteShader(T),y=new Kr(s,p),E=b1(s,p)}let y;this.getUniforms=function(){return y===void 0&&R(this),y};let E;this.getAttributes=function(){return E===void 0&&R(this),E};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(p,h1)),D},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=u1++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=T,this}var L1=0,Lf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Df(t),e.set(t,n)),n}},Df=class{constructor(t){this.id=L1++,this.code=t,this.usedTimes=0}};function D1(i){return i===ds||i===Pa||i===Ia}function N1(i,t,e,n,s,r){let o=new Xo,a=new Lf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,E,D,P,k,O){let B=P.fog,I=k.geometry,V=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,X=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=t.get(y.envMap||V,X),et=d[y.type],$=n.precision;y.precision!==null&&($=n.getMaxPrecision(y.precision),$!==y.precision&&Dt("WebGLProgram.getParameters:",y.precision,"not supported, using",$,"instead."));let J=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,tt=J!==void 0?J.length:0,wt=0;I.morphAttributes.position!==void 0&&(wt=1),I.morphAttributes.normal!==void 0&&(wt=2),I.morphAttributes.color!==void 0&&(wt=3);let Nt,Z,yt,Tt;if(et){let xt=xn[et];Nt=xt.vertexShader,Z=xt.fragmentShader}else{Nt=y.vertexShader,Z=y.fragmentShader;let xt=a.getVertexShaderStage(y),ge=a.getFragmentShaderStage(y);a.update(y,xt,ge),yt=xt.id,Tt=ge.id}let kt=i.getRenderTarget(),vt=i.state.buffers.depth.getReversed(),Yt=k.isInstancedMesh===!0,Ae=k.isBatchedMesh===!0,Ut=!!y.map,me=!!y.matcap,xe=!!H,ee=xe&&H.isPMREMTexture===!0,We=!!y.aoMap,Pe=!!y.lightMap,_n=!!y.bumpMap&&y.wireframe===!1,Se=!!y.normalMap,ci=!!y.displacementMap,Ue=!!y.emissiveMap,Fn=!!y.metalnessMap,Un=!!y.roughnessMap,Bn=y.anisotropy>0,F=y.clearcoat>0,zn=y.diffuseRoughness>0,we=y.dispersion>0,Me=y.retroreflectivity>0,mt=y.iridescence>0,Ie=y.sheen>0,Ot=y.transmission>0,$t=Bn&&!!y.anisotropyMap,C=F&&!!y.clearcoatMap,w=F&&!!y.clearcoatNormalMap,z=F&&!!y.clearcoatRoughnessMap,nt=zn&&!!y.diffuseRoughnessMap,Q=mt&&!!y.iridescenceMap,at=mt&&!!y.iridescenceThicknessMap,dt=Ie&&!!y.sheenColorMap,Y=Ie&&!!y.sheenRoughnessMap,j=!!y.specularMap,ct=!!y.specularColorMap,L=!!y.specularIntensityMap,K=Ot&&!!y.transmissionMap,q=Ot&&!!y.thicknessMap,ht=!!y.gradientMap,rt=!!y.alphaMap,lt=y.alphaTest>0,Pt=!!y.alphaHash,Kt=!!y.extensions,it=gi;y.toneMapped&&(kt===null||kt.isXRRenderTarget===!0)&&(it=i.toneMapping);let It=ee?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,jt={shaderID:et,shaderType:y.type,shaderName:y.name,vertexShader:Nt,fragmentShader:Z,defines:y.defines,customVertexShaderID:yt,customFragmentShaderID:Tt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:$,batching:Ae,batchingColor:Ae&&k._colorsTexture!==null,instancing:Yt,instancingColor:Yt&&k.instanceColor!==null,instancingMorph:Yt&&k.morphTexture!==null,outputColorSpace:kt===null?i.outputColorSpace:kt.isXRRenderTarget===!0?kt.texture.colorSpace:se.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ut,matcap:me,envMap:xe,envMapMode:xe&&H.mapping,envMapPMREM:ee,envMapMaxLod:ee?It.length-1:null,envMapSize:ee?It[0].width:null,aoMap:We,lightMap:Pe,bumpMap:_n,normalMap:Se,displacementMap:ci,emissiveMap:Ue,normalMapObjectSpace:Se&&y.normalMapType===Og,normalMapTangentSpace:Se&&y.normalMapType===Zr,packedNormalMap:Se&&y.normalMapType===Zr&&D1(y.normalMap.format),metalnessMap:Fn,roughnessMap:Un,anisotropy:Bn,anisotropyMap:$t,clearcoat:F,clearcoatMap:C,clearcoatNormalMap:w,clearcoatRoughnessMap:z,diffuseRoughness:zn,diffuseRoughnessMap:nt,dispersion:we,retroreflection:Me,iridescence:mt,iridescenceMap:Q,iridescenceThicknessMap:at,sheen:Ie,sheenColorMap:dt,sheenRoughnessMap:Y,specularMap:j,specularColorMap:ct,specularIntensityMap:L,transmission:Ot,transmissionMap:K,thicknessMap:q,gradientMap:ht,opaque:y.transparent===!1&&y.blending===Xr&&y.alphaToCoverage===!1,alphaMap:rt,alphaTest:lt,alphaHash:Pt,combine:y.combine,mapUv:Ut&&f(y.map.channel),aoMapUv:We&&f(y.aoMap.channel),lightMapUv:Pe&&f(y.lightMap.channel),bumpMapUv:_n&&f(y.bumpMap.channel),normalMapUv:Se&&f(y.normalMap.channel),displacementMapUv:ci&&f(y.displacementMap.channel),emissiveMapUv:Ue&&f(y.emissiveMap.channel),metalnessMapUv:Fn&&f(y.metalnessMap.channel),roughnessMapUv:Un&&f(y.roughnessMap.channel),anisotropyMapUv:$t&&f(y.anisotropyMap.channel),clearcoatMapUv:C&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:nt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:at&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:dt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:Y&&f(y.sheenRoughnessMap.channel),specularMapUv:j&&f(y.specularMap.channel),specularColorMapUv:ct&&f(y.specularColorMap.channel),specularIntensityMapUv:L&&f(y.specularIntensityMap.channel),transmissionMapUv:K&&f(y.transmissionMap.channel),thicknessMapUv:q&&f(y.thicknessMap.channel),alphaMapUv:rt&&f(y.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Se||Bn),vertexNormals:!!I.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:k.isPoints===!0&&!!I.attributes.uv&&(Ut||rt),fog:!!B,useFog:y.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||I.attributes.normal===void 0&&Se===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:vt,skinning:k.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:wt,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:O.filter(xt=>xt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&D.length>0,shadowMapType:i.shadowMap.type,toneMapping:it,decodeVideoTexture:Ut&&y.map.isVideoTexture===!0&&se.getTransfer(y.map.colorSpace)===fe,decodeVideoTextureEmissive:Ue&&y.emissiveMap.isVideoTexture===!0&&se.getTransfer(y.emissiveMap.colorSpace)===fe,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===cn,flipSided:y.side===gn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Kt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Kt&&y.extensions.multiDraw===!0||Ae)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return jt.vertexUv1s=l.has(1),jt.vertexUv2s=l.has(2),jt.vertexUv3s=l.has(3),l.clear(),jt}function x(y){let E=[];if(y.shaderID?E.push(y.shaderID):(E.push(y.customVertexShaderID),E.push(y.customFragmentShaderID)),y.defines!==void 0)for(let D in y.defines)E.push(D),E.push(y.defines[D]);return y.isRawShaderMaterial===!1&&(m(E,y),g(E,y),E.push(i.outputColorSpace)),E.push(y.customProgramCacheKey),E.join()}function m(y,E){y.push(E.precision),y.push(E.outputColorSpace),y.push(E.envMapMode),y.push(E.envMapPMREM),y.push(E.envMapMaxLod),y.push(E.envMapSize),y.push(E.mapUv),y.push(E.alphaMapUv),y.push(E.lightMapUv),y.push(E.aoMapUv),y.push(E.bumpMapUv),y.push(E.normalMapUv),y.push(E.displacementMapUv),y.push(E.emissiveMapUv),y.push(E.metalnessMapUv),y.push(E.roughnessMapUv),y.push(E.anisotropyMapUv),y.push(E.clearcoatMapUv),y.push(E.clearcoatNormalMapUv),y.push(E.clearcoatRoughnessMapUv),y.push(E.diffuseRoughnessMapUv),y.push(E.iridescenceMapUv),y.push(E.iridescenceThicknessMapUv),y.push(E.sheenColorMapUv),y.push(E.sheenRoughnessMapUv),y.push(E.specularMapUv),y.push(E.specularColorMapUv),y.push(E.specularIntensityMapUv),y.push(E.transmissionMapUv),y.push(E.thicknessMapUv),y.push(E.combine),y.push(E.fogExp2),y.push(E.sizeAttenuation),y.push(E.morphTargetsCount),y.push(E.numSunLights),y.push(E.numDirLights),y.push(E.numPointLights),y.push(E.numSpotLights),y.push(E.numSpotLightMaps),y.push(E.numHemiLights),y.push(E.numRectAreaLights),y.push(E.numSunLightShadows),y.push(E.numDirLightShadows),y.push(E.numPointLightShadows),y.push(E.numSpotLightShadows),y.push(E.numSpotLightShadowsWithMaps),y.push(E.numLightProbes),y.push(E.numLightProbeGrids),y.push(E.shadowMapType),y.push(E.toneMapping),y.push(E.numClippingPlanes),y.push(E.numClipIntersection),y.push(E.depthPacking)}function g(y,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function v(y){let E=d[y.type],D;if(E){let P=xn[E];D=La.clone(P.uniforms)}else D=y.uniforms;return D}function S(y,E){let D=h.get(E);return D!==void 0?++D.usedTimes:(D=new I1(i,E,y,s),c.push(D),h.set(E,D)),D}function b(y){if(--y.usedTimes===0){let E=c.indexOf(y);c[E]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function T(y){a.remove(y)}function R(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:v,acquireProgram:S,releaseProgram:b,releaseShaderCache:T,programs:c,dispose:R}}function k1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function O1(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function y0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function v0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let v=i[t];return v===void 0?(v={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},i[t]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=p,v.materialVariant=o(d),v.groupOrder=x,v.renderOrder=d.renderOrder,v.z=m,v.group=g),t++,v}function l(d,f,p,x,m,g,v){v.reversedDepth===!0&&(m=-m);let S=a(d,f,p,x,m,g);p.transmission>0?n.push(S):p.transparent===!0?s.push(S):e.push(S)}function c(d,f,p,x,m,g){let v=a(d,f,p,x,m,g);p.transmission>0?n.unshift(v):p.transparent===!0?s.unshift(v):e.unshift(v)}function h(d,f){e.length>1&&e.sort(d||O1),n.length>1&&n.sort(f||y0),s.length>1&&s.sort(f||y0)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function F1(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new v0,i.set(n,[o])):s>=r.length?(o=new v0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function U1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new A,color:new Mt};break;case"SpotLight":e={position:new A,direction:new A,color:new Mt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new A,color:new Mt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new A,skyColor:new Mt,groundColor:new Mt};break;case"RectAreaLight":e={color:new Mt,position:new A,halfWidth:new A,halfHeight:new A};break}return i[t.id]=e,e}}}function B1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new st};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new st};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new st,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var z1=0;function G1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function V1(i){let t=new U1,e=B1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new A);let s=new A,r=new Lt,o=new Lt;function a(c){let h=0,u=0,d=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,v=0,S=0,b=0,T=0,R=0,y=0,E=0,D=0,P=0;c.sort(G1);for(let O=0,B=c.length;O<B;O++){let I=c[O],V=I.color,X=I.intensity,H=I.distance,et=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===ds?et=I.shadow.map.texture:et=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=V.r*X,u+=V.g*X,d+=V.b*X;else if(I.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(I.sh.coefficients[$],X);P++}else if(I.isSunLight){let $=t.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let J=I.shadow,tt=e.get(I);tt.shadowIntensity=J.intensity,tt.shadowBias=J.bias,tt.shadowNormalBias=J.normalBias,tt.shadowRadius=J.radius,tt.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),n.sunShadow[p]=tt,n.sunShadowMap[p]=et;let wt=J.getViewportCount();for(let Nt=0;Nt<wt;Nt++)n.sunShadowMatrix[x+Nt]=J.getMatrix(Nt),n.sunShadowCascade[x+Nt]=J._cascadeData[Nt];x+=wt,p++}n.sun[f]=$,f++}else if(I.isDirectionalLight){let $=t.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let J=I.shadow,tt=e.get(I);tt.shadowIntensity=J.intensity,tt.shadowBias=J.bias,tt.shadowNormalBias=J.normalBias,tt.shadowRadius=J.radius,tt.shadowMapSize=J.mapSize,n.directionalShadow[m]=tt,n.directionalShadowMap[m]=et,n.directionalShadowMatrix[m]=I.shadow.matrix,T++}n.directional[m]=$,m++}else if(I.isSpotLight){let $=t.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(V).multiplyScalar(X),$.distance=H,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,n.spot[v]=$;let J=I.shadow;if(I.map&&(n.spotLightMap[E]=I.map,E++,J.updateMatrices(I),I.castShadow&&D++),n.spotLightMatrix[v]=J.matrix,I.castShadow){let tt=e.get(I);tt.shadowIntensity=J.intensity,tt.shadowBias=J.bias,tt.shadowNormalBias=J.normalBias,tt.shadowRadius=J.radius,tt.shadowMapSize=J.mapSize,n.spotShadow[v]=tt,n.spotShadowMap[v]=et,y++}v++}else if(I.isRectAreaLight){let $=t.get(I);$.color.copy(V).multiplyScalar(X),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),n.rectArea[S]=$,S++}else if(I.isPointLight){let $=t.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let J=I.shadow,tt=e.get(I);tt.shadowIntensity=J.intensity,tt.shadowBias=J.bias,tt.shadowNormalBias=J.normalBias,tt.shadowRadius=J.radius,tt.shadowMapSize=J.mapSize,tt.shadowCameraNear=J.camera.near,tt.shadowCameraFar=J.camera.far,n.pointShadow[g]=tt,n.pointShadowMap[g]=et,n.pointShadowMatrix[g]=I.shadow.matrix,R++}n.point[g]=$,g++}else if(I.isHemisphereLight){let $=t.get(I);$.skyColor.copy(I.color).multiplyScalar(X),$.groundColor.copy(I.groundColor).multiplyScalar(X),n.hemi[b]=$,b++}}S>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=pt.LTC_FLOAT_1,n.rectAreaLTC2=pt.LTC_FLOAT_2):(n.rectAreaLTC1=pt.LTC_HALF_1,n.rectAreaLTC2=pt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let k=n.hash;(k.sunLength!==f||k.directionalLength!==m||k.pointLength!==g||k.spotLength!==v||k.rectAreaLength!==S||k.hemiLength!==b||k.numSunShadows!==p||k.numDirectionalShadows!==T||k.numPointShadows!==R||k.numSpotShadows!==y||k.numSpotMaps!==E||k.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=S,n.point.length=g,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=T,n.directionalShadowMap.length=T,n.directionalShadowMatrix.length=T,n.pointShadow.length=R,n.pointShadowMap.length=R,n.pointShadowMatrix.length=R,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+E-D,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=P,k.sunLength=f,k.directionalLength=m,k.pointLength=g,k.spotLength=v,k.rectAreaLength=S,k.hemiLength=b,k.numSunShadows=p,k.numDirectionalShadows=T,k.numPointShadows=R,k.numSpotShadows=y,k.numSpotMaps=E,k.numLightProbes=P,n.version=z1++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let v=0,S=c.length;v<S;v++){let b=c[v];if(b.isSunLight){let T=n.sun[u];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(g),u++}else if(b.isDirectionalLight){let T=n.directional[d];T.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(g),d++}else if(b.isSpotLight){let T=n.spot[p];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(g),T.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let T=n.rectArea[x];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),T.halfWidth.set(b.width*.5,0,0),T.halfHeight.set(0,b.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let T=n.point[f];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let T=n.hemi[m];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function b0(i){let t=new V1(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function H1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new b0(i),t.set(s,[a])):r>=o.length?(a=new b0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var W1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,X1=[new A(1,0,0),new A(-1,0,0),new A(0,1,0),new A(0,-1,0),new A(0,0,1),new A(0,0,-1)],q1=[new A(0,-1,0),new A(0,-1,0),new A(0,0,1),new A(0,0,-1),new A(0,-1,0),new A(0,-1,0)],_0=new Lt,Da=new A,Af=new A;function Y1(i,t,e){let n=new is,s=new st,r=new st,o=new pe,a=new Sc,l=new Tc,c={},h=e.maxTextureSize,u={[us]:gn,[gn]:us,[cn]:cn},d=new $n({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new st},radius:{value:4}},vertexShader:W1,fragmentShader:$1}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Ft;p.setAttribute("position",new re(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new ae(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Fs;let g=this.type;this.render=function(R,y,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;this.type===fg&&(Dt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Fs);let D=i.getRenderTarget(),P=i.getActiveCubeFace(),k=i.getActiveMipmapLevel(),O=i.state;O.setBlending(Us),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let B=g!==this.type;B&&y.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=R.length;I<V;I++){let X=R[I],H=X.shadow;if(H===void 0){Dt("WebGLShadowMap:",X,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let et=H.getFrameExtents();s.multiply(et),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,H.mapSize.y=r.y));let $=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=$,H.map===null||B===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===$r){if(X.isPointLight){Dt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new In(s.x,s.y,{format:ds,type:si,minFilter:pn,magFilter:pn,generateMipmaps:!1}),H.map.texture.name=X.name+".shadowMap",H.map.depthTexture=new Di(s.x,s.y,Xn),H.map.depthTexture.name=X.name+".shadowMapDepth",H.map.depthTexture.format=Ii,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Ve,H.map.depthTexture.magFilter=Ve}else X.isPointLight?(H.map=new ka(s.x),H.map.depthTexture=new Qo(s.x,ii)):(H.map=new In(s.x,s.y),H.map.depthTexture=new Di(s.x,s.y,ii)),H.map.depthTexture.name=X.name+".shadowMap",H.map.depthTexture.format=Ii,this.type===Fs?(H.map.depthTexture.compareFunction=$?ff:df,H.map.depthTexture.minFilter=pn,H.map.depthTexture.magFilter=pn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Ve,H.map.depthTexture.magFilter=Ve);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let J=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();X.isPointLight!==!0&&H.updateMatrices(X,E);let tt=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let wt=0;wt<J;wt++){let Nt=H.getCamera(wt);if(X.isPointLight){let Z=H.camera,yt=H.matrix,Tt=X.distance||Z.far;Tt!==Z.far&&(Z.far=Tt,Z.updateProjectionMatrix()),Da.setFromMatrixPosition(X.matrixWorld),Z.position.copy(Da),Af.copy(Z.position),Af.add(X1[wt]),Z.up.copy(q1[wt]),Z.lookAt(Af),Z.updateMatrixWorld(),yt.makeTranslation(-Da.x,-Da.y,-Da.z),_0.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),H._frustum.setFromProjectionMatrix(_0,Z.coordinateSystem,Z.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,wt),i.clear();else{wt===0&&(i.setRenderTarget(H.map),i.clear());let Z=H.getViewport(wt);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),O.viewport(o)}n=H.getFrustum(wt),b(y,E,Nt,X,tt,this.type)}H.isPointLightShadow!==!0&&this.type===$r&&v(H,E),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(D,P,k)};function v(R,y){let E=t.update(x);d.defines.VSM_SAMPLES!==R.blurSamples&&(d.defines.VSM_SAMPLES=R.blurSamples,f.defines.VSM_SAMPLES=R.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),R.mapPass===null?R.mapPass=new In(s.x,s.y,{format:ds,type:si}):(R.mapPass.width!==R.map.width||R.mapPass.height!==R.map.height)&&R.mapPass.setSize(R.map.width,R.map.height),d.uniforms.shadow_pass.value=R.map.depthTexture,d.uniforms.resolution.value.set(R.map.width,R.map.height),d.uniforms.radius.value=R.radius,i.setRenderTarget(R.mapPass),i.clear(),i.renderBufferDirect(y,null,E,d,x,null),f.uniforms.shadow_pass.value=R.mapPass.texture,f.uniforms.resolution.value.set(R.map.width,R.map.height),f.uniforms.radius.value=R.radius,i.setRenderTarget(R.map),i.clear(),i.renderBufferDirect(y,null,E,f,x,null)}function S(R,y,E,D){let P=null,k=E.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(k!==void 0)P=k;else if(P=E.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let O=P.uuid,B=y.uuid,I=c[O];I===void 0&&(I={},c[O]=I);let V=I[B];V===void 0&&(V=P.clone(),I[B]=V,y.addEventListener("dispose",T)),P=V}if(P.visible=y.visible,P.wireframe=y.wireframe,D===$r?P.side=y.shadowSide!==null?y.shadowSide:y.side:P.side=y.shadowSide!==null?y.shadowSide:u[y.side],P.alphaMap=y.alphaMap,P.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,P.map=y.map,P.clipShadows=y.clipShadows,P.clippingPlanes=y.clippingPlanes,P.clipIntersection=y.clipIntersection,P.displacementMap=y.displacementMap,P.displacementScale=y.displacementScale,P.displacementBias=y.displacementBias,P.wireframeLinewidth=y.wireframeLinewidth,P.linewidth=y.linewidth,E.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let O=i.properties.get(P);O.light=E}return P}function b(R,y,E,D,P,k){if(R.visible===!1)return;if(R.layers.test(P)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&k===$r)&&(!R.frustumCulled||R.intersectsFrustum(n))){R.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,R.matrixWorld);let I=t.update(R),V=R.material;if(Array.isArray(V)){let X=I.groups;for(let H=0,et=X.length;H<et;H++){let $=X[H],J=V[$.materialIndex];if(J&&J.visible){let tt=S(R,J,D,k);R.onBeforeShadow(i,R,y,E,I,tt,$),i.renderBufferDirect(E,null,I,tt,R,$),R.onAfterShadow(i,R,y,E,I,tt,$)}}}else if(V.visible){let X=S(R,V,D,k);R.onBeforeShadow(i,R,y,E,I,X,null),i.renderBufferDirect(E,null,I,X,R,null),R.onAfterShadow(i,R,y,E,I,X,null)}}let B=R.children;for(let I=0,V=B.length;I<V;I++)b(B[I],y,E,D,P,k)}function T(R){R.target.removeEventListener("dispose",T);for(let E in c){let D=c[E],P=R.target.uuid;P in D&&(D[P].dispose(),delete D[P])}}}function Z1(i,t){function e(){let L=!1,K=new pe,q=null,ht=new pe(0,0,0,0);return{setMask:function(rt){q!==rt&&!L&&(i.colorMask(rt,rt,rt,rt),q=rt)},setLocked:function(rt){L=rt},setClear:function(rt,lt,Pt,Kt,it){it===!0&&(rt*=Kt,lt*=Kt,Pt*=Kt),K.set(rt,lt,Pt,Kt),ht.equals(K)===!1&&(i.clearColor(rt,lt,Pt,Kt),ht.copy(K))},reset:function(){L=!1,q=null,ht.set(-1,0,0,0)}}}function n(){let L=!1,K=!1,q=null,ht=null,rt=null;return{setReversed:function(lt){if(K!==lt){let Pt=t.get("EXT_clip_control");lt?Pt.clipControlEXT(Pt.LOWER_LEFT_EXT,Pt.ZERO_TO_ONE_EXT):Pt.clipControlEXT(Pt.LOWER_LEFT_EXT,Pt.NEGATIVE_ONE_TO_ONE_EXT),K=lt;let Kt=rt;rt=null,this.setClear(Kt)}},getReversed:function(){return K},setTest:function(lt){lt?vt(i.DEPTH_TEST):Yt(i.DEPTH_TEST)},setMask:function(lt){q!==lt&&!L&&(i.depthMask(lt),q=lt)},setFunc:function(lt){if(K&&(lt=Xg[lt]),ht!==lt){switch(lt){case ec:i.depthFunc(i.NEVER);break;case nc:i.depthFunc(i.ALWAYS);break;case ic:i.depthFunc(i.LESS);break;case Rr:i.depthFunc(i.LEQUAL);break;case sc:i.depthFunc(i.EQUAL);break;case rc:i.depthFunc(i.GEQUAL);break;case oc:i.depthFunc(i.GREATER);break;case ac:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ht=lt}},setLocked:function(lt){L=lt},setClear:function(lt){rt!==lt&&(rt=lt,K&&(lt=1-lt),i.clearDepth(lt))},reset:function(){L=!1,q=null,ht=null,rt=null,K=!1}}}function s(){let L=!1,K=null,q=null,ht=null,rt=null,lt=null,Pt=null,Kt=null,it=null;return{setTest:function(It){L||(It?vt(i.STENCIL_TEST):Yt(i.STENCIL_TEST))},setMask:function(It){K!==It&&!L&&(i.stencilMask(It),K=It)},setFunc:function(It,jt,xt){(q!==It||ht!==jt||rt!==xt)&&(i.stencilFunc(It,jt,xt),q=It,ht=jt,rt=xt)},setOp:function(It,jt,xt){(lt!==It||Pt!==jt||Kt!==xt)&&(i.stencilOp(It,jt,xt),lt=It,Pt=jt,Kt=xt)},setLocked:function(It){L=It},setClear:function(It){it!==It&&(i.clearStencil(It),it=It)},reset:function(){L=!1,K=null,q=null,ht=null,rt=null,lt=null,Pt=null,Kt=null,it=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,v=null,S=null,b=null,T=null,R=null,y=null,E=new Mt(0,0,0),D=0,P=!1,k=null,O=null,B=null,I=null,V=null,X=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,et=0,$=i.getParameter(i.VERSION);$.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec($)[1]),H=et>=1):$.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),H=et>=2);let J=null,tt={},wt=i.getParameter(i.SCISSOR_BOX),Nt=i.getParameter(i.VIEWPORT),Z=new pe().fromArray(wt),yt=new pe().fromArray(Nt);function Tt(L,K,q,ht){let rt=new Uint8Array(4),lt=i.createTexture();i.bindTexture(L,lt),i.texParameteri(L,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(L,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Pt=0;Pt<q;Pt++)L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,ht,0,i.RGBA,i.UNSIGNED_BYTE,rt):i.texImage2D(K+Pt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,rt);return lt}let kt={};kt[i.TEXTURE_2D]=Tt(i.TEXTURE_2D,i.TEXTURE_2D,1),kt[i.TEXTURE_CUBE_MAP]=Tt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),kt[i.TEXTURE_2D_ARRAY]=Tt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),kt[i.TEXTURE_3D]=Tt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),vt(i.DEPTH_TEST),o.setFunc(Rr),_n(!1),Se($d),vt(i.CULL_FACE),We(Us);function vt(L){h[L]!==!0&&(i.enable(L),h[L]=!0)}function Yt(L){h[L]!==!1&&(i.disable(L),h[L]=!1)}function Ae(L,K){return d[L]!==K?(i.bindFramebuffer(L,K),d[L]=K,L===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),L===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Ut(L,K){let q=p,ht=!1;if(L){q=f.get(K),q===void 0&&(q=[],f.set(K,q));let rt=L.textures;if(q.length!==rt.length||q[0]!==i.COLOR_ATTACHMENT0){for(let lt=0,Pt=rt.length;lt<Pt;lt++)q[lt]=i.COLOR_ATTACHMENT0+lt;q.length=rt.length,ht=!0}}else q[0]!==i.BACK&&(q[0]=i.BACK,ht=!0);ht&&i.drawBuffers(q)}function me(L){return x!==L?(i.useProgram(L),x=L,!0):!1}let xe={[Bs]:i.FUNC_ADD,[mg]:i.FUNC_SUBTRACT,[gg]:i.FUNC_REVERSE_SUBTRACT};xe[xg]=i.MIN,xe[yg]=i.MAX;let ee={[vg]:i.ZERO,[bg]:i.ONE,[_g]:i.SRC_COLOR,[Zd]:i.SRC_ALPHA,[Ag]:i.SRC_ALPHA_SATURATE,[Tg]:i.DST_COLOR,[Mg]:i.DST_ALPHA,[wg]:i.ONE_MINUS_SRC_COLOR,[jd]:i.ONE_MINUS_SRC_ALPHA,[Eg]:i.ONE_MINUS_DST_COLOR,[Sg]:i.ONE_MINUS_DST_ALPHA,[Rg]:i.CONSTANT_COLOR,[Cg]:i.ONE_MINUS_CONSTANT_COLOR,[Pg]:i.CONSTANT_ALPHA,[Ig]:i.ONE_MINUS_CONSTANT_ALPHA};function We(L,K,q,ht,rt,lt,Pt,Kt,it,It){if(L===Us){m===!0&&(Yt(i.BLEND),m=!1);return}if(m===!1&&(vt(i.BLEND),m=!0),L!==pg){if(L!==g||It!==P){if((v!==Bs||T!==Bs)&&(i.blendEquation(i.FUNC_ADD),v=Bs,T=Bs),It)switch(L){case Xr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Xd:i.blendFunc(i.ONE,i.ONE);break;case qd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Yd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Bt("WebGLState: Invalid blending: ",L);break}else switch(L){case Xr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Xd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case qd:Bt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Yd:Bt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Bt("WebGLState: Invalid blending: ",L);break}S=null,b=null,R=null,y=null,E.set(0,0,0),D=0,g=L,P=It}return}rt=rt||K,lt=lt||q,Pt=Pt||ht,(K!==v||rt!==T)&&(i.blendEquationSeparate(xe[K],xe[rt]),v=K,T=rt),(q!==S||ht!==b||lt!==R||Pt!==y)&&(i.blendFuncSeparate(ee[q],ee[ht],ee[lt],ee[Pt]),S=q,b=ht,R=lt,y=Pt),(Kt.equals(E)===!1||it!==D)&&(i.blendColor(Kt.r,Kt.g,Kt.b,it),E.copy(Kt),D=it),g=L,P=!1}function Pe(L,K){L.side===cn?Yt(i.CULL_FACE):vt(i.CULL_FACE);let q=L.side===gn;K&&(q=!q),_n(q),L.blending===Xr&&L.transparent===!1?We(Us):We(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),o.setFunc(L.depthFunc),o.setTest(L.depthTest),o.setMask(L.depthWrite),r.setMask(L.colorWrite);let ht=L.stencilWrite;a.setTest(ht),ht&&(a.setMask(L.stencilWriteMask),a.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),a.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),Ue(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?vt(i.SAMPLE_ALPHA_TO_COVERAGE):Yt(i.SAMPLE_ALPHA_TO_COVERAGE)}function _n(L){k!==L&&(L?i.frontFace(i.CW):i.frontFace(i.CCW),k=L)}function Se(L){L!==ug?(vt(i.CULL_FACE),L!==O&&(L===$d?i.cullFace(i.BACK):L===dg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Yt(i.CULL_FACE),O=L}function ci(L){L!==B&&(H&&i.lineWidth(L),B=L)}function Ue(L,K,q){L?(vt(i.POLYGON_OFFSET_FILL),(I!==K||V!==q)&&(I=K,V=q,o.getReversed()&&(K=-K,q=-q),i.polygonOffset(K,q))):Yt(i.POLYGON_OFFSET_FILL)}function Fn(L){L?vt(i.SCISSOR_TEST):Yt(i.SCISSOR_TEST)}function Un(L){L===void 0&&(L=i.TEXTURE0+X-1),J!==L&&(i.activeTexture(L),J=L)}function Bn(L,K,q){q===void 0&&(J===null?q=i.TEXTURE0+X-1:q=J);let ht=tt[q];ht===void 0&&(ht={type:void 0,texture:void 0},tt[q]=ht),(ht.type!==L||ht.texture!==K)&&(J!==q&&(i.activeTexture(q),J=q),i.bindTexture(L,K||kt[L]),ht.type=L,ht.texture=K)}function F(){let L=tt[J];L!==void 0&&L.type!==void 0&&(i.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function zn(){try{i.compressedTexImage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function we(){try{i.compressedTexImage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function Me(){try{i.texSubImage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function mt(){try{i.texSubImage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function Ie(){try{i.compressedTexSubImage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function Ot(){try{i.compressedTexSubImage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function $t(){try{i.texStorage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function C(){try{i.texStorage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function w(){try{i.texImage2D(...arguments)}catch(L){Bt("WebGLState:",L)}}function z(){try{i.texImage3D(...arguments)}catch(L){Bt("WebGLState:",L)}}function nt(L){return u[L]!==void 0?u[L]:i.getParameter(L)}function Q(L,K){u[L]!==K&&(i.pixelStorei(L,K),u[L]=K)}function at(L){Z.equals(L)===!1&&(i.scissor(L.x,L.y,L.z,L.w),Z.copy(L))}function dt(L){yt.equals(L)===!1&&(i.viewport(L.x,L.y,L.z,L.w),yt.copy(L))}function Y(L,K){let q=c.get(K);q===void 0&&(q=new WeakMap,c.set(K,q));let ht=q.get(L);ht===void 0&&(ht=i.getUniformBlockIndex(K,L.name),i.uniformBlockBinding(K,ht,ht),q.set(L,ht))}function j(L,K,q){let rt=c.get(K).get(L);l[rt]!==q&&(i.bindBufferBase(i.UNIFORM_BUFFER,rt,q),l[rt]=q)}function ct(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},J=null,tt={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,v=null,S=null,b=null,T=null,R=null,y=null,E=new Mt(0,0,0),D=0,P=!1,k=null,O=null,B=null,I=null,V=null,Z.set(0,0,i.canvas.width,i.canvas.height),yt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:vt,disable:Yt,bindFramebuffer:Ae,drawBuffers:Ut,useProgram:me,setBlending:We,setMaterial:Pe,setFlipSided:_n,setCullFace:Se,setLineWidth:ci,setPolygonOffset:Ue,setScissorTest:Fn,activeTexture:Un,bindTexture:Bn,unbindTexture:F,compressedTexImage2D:zn,compressedTexImage3D:we,texImage2D:w,texImage3D:z,pixelStorei:Q,getParameter:nt,updateUBOMapping:Y,uniformBlockBinding:j,texStorage2D:$t,texStorage3D:C,texSubImage2D:Me,texSubImage3D:mt,compressedTexSubImage2D:Ie,compressedTexSubImage3D:Ot,scissor:at,viewport:dt,reset:ct}}function j1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new st,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(C=>p.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(C,w){return m?new OffscreenCanvas(C,w):Ho("canvas")}function v(C,w,z){let nt=1,Q=$t(C);if((Q.width>z||Q.height>z)&&(nt=z/Math.max(Q.width,Q.height)),nt<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let at=Math.floor(nt*Q.width),dt=Math.floor(nt*Q.height);d===void 0&&(d=g(at,dt));let Y=w?g(at,dt):d;return Y.width=at,Y.height=dt,Y.getContext("2d").drawImage(C,0,0,at,dt),Dt("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+at+"x"+dt+")."),Y}else return"data"in C&&Dt("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),C;return C}function S(C){return C.generateMipmaps}function b(C){i.generateMipmap(C)}function T(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function R(C,w,z,nt,Q,at=!1){if(C!==null){if(i[C]!==void 0)return i[C];Dt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let dt;nt&&(dt=t.get("EXT_texture_norm16"),dt||Dt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=w;if(w===i.RED&&(z===i.FLOAT&&(Y=i.R32F),z===i.HALF_FLOAT&&(Y=i.R16F),z===i.UNSIGNED_BYTE&&(Y=i.R8),z===i.UNSIGNED_SHORT&&dt&&(Y=dt.R16_EXT),z===i.SHORT&&dt&&(Y=dt.R16_SNORM_EXT)),w===i.RED_INTEGER&&(z===i.UNSIGNED_BYTE&&(Y=i.R8UI),z===i.UNSIGNED_SHORT&&(Y=i.R16UI),z===i.UNSIGNED_INT&&(Y=i.R32UI),z===i.BYTE&&(Y=i.R8I),z===i.SHORT&&(Y=i.R16I),z===i.INT&&(Y=i.R32I)),w===i.RG&&(z===i.FLOAT&&(Y=i.RG32F),z===i.HALF_FLOAT&&(Y=i.RG16F),z===i.UNSIGNED_BYTE&&(Y=i.RG8),z===i.UNSIGNED_SHORT&&dt&&(Y=dt.RG16_EXT),z===i.SHORT&&dt&&(Y=dt.RG16_SNORM_EXT)),w===i.RG_INTEGER&&(z===i.UNSIGNED_BYTE&&(Y=i.RG8UI),z===i.UNSIGNED_SHORT&&(Y=i.RG16UI),z===i.UNSIGNED_INT&&(Y=i.RG32UI),z===i.BYTE&&(Y=i.RG8I),z===i.SHORT&&(Y=i.RG16I),z===i.INT&&(Y=i.RG32I)),w===i.RGB_INTEGER&&(z===i.UNSIGNED_BYTE&&(Y=i.RGB8UI),z===i.UNSIGNED_SHORT&&(Y=i.RGB16UI),z===i.UNSIGNED_INT&&(Y=i.RGB32UI),z===i.BYTE&&(Y=i.RGB8I),z===i.SHORT&&(Y=i.RGB16I),z===i.INT&&(Y=i.RGB32I)),w===i.RGBA_INTEGER&&(z===i.UNSIGNED_BYTE&&(Y=i.RGBA8UI),z===i.UNSIGNED_SHORT&&(Y=i.RGBA16UI),z===i.UNSIGNED_INT&&(Y=i.RGBA32UI),z===i.BYTE&&(Y=i.RGBA8I),z===i.SHORT&&(Y=i.RGBA16I),z===i.INT&&(Y=i.RGBA32I)),w===i.RGB&&(z===i.UNSIGNED_SHORT&&dt&&(Y=dt.RGB16_EXT),z===i.SHORT&&dt&&(Y=dt.RGB16_SNORM_EXT),z===i.UNSIGNED_INT_5_9_9_9_REV&&(Y=i.RGB9_E5),z===i.UNSIGNED_INT_10F_11F_11F_REV&&(Y=i.R11F_G11F_B10F)),w===i.RGBA){let j=at?Vo:se.getTransfer(Q);z===i.FLOAT&&(Y=i.RGBA32F),z===i.HALF_FLOAT&&(Y=i.RGBA16F),z===i.UNSIGNED_BYTE&&(Y=j===fe?i.SRGB8_ALPHA8:i.RGBA8),z===i.UNSIGNED_SHORT&&dt&&(Y=dt.RGBA16_EXT),z===i.SHORT&&dt&&(Y=dt.RGBA16_SNORM_EXT),z===i.UNSIGNED_SHORT_4_4_4_4&&(Y=i.RGBA4),z===i.UNSIGNED_SHORT_5_5_5_1&&(Y=i.RGB5_A1)}return(Y===i.R16F||Y===i.R32F||Y===i.RG16F||Y===i.RG32F||Y===i.RGBA16F||Y===i.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function y(C,w){let z;return C?w===null||w===ii||w===Gs?z=i.DEPTH24_STENCIL8:w===Xn?z=i.DEPTH32F_STENCIL8:w===Yr&&(z=i.DEPTH24_STENCIL8,Dt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===ii||w===Gs?z=i.DEPTH_COMPONENT24:w===Xn?z=i.DEPTH_COMPONENT32F:w===Yr&&(z=i.DEPTH_COMPONENT16),z}function E(C,w){return S(C)===!0||C.isFramebufferTexture&&C.minFilter!==Ve&&C.minFilter!==pn?Math.log2(Math.max(w.width,w.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?w.mipmaps.length:1}function D(C){let w=new WeakRef(C);n.get(C).__ref=w,p.add(w),x.register(C,w,w)}function P(C){let w=n.get(C).__ref;w!==void 0&&(p.delete(w),x.unregister(w))}function k(C){B(C.target)}function O(C){I(C.target)}function B(C){C.removeEventListener("dispose",k),P(C),X(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&u.delete(C)}function I(C){C.removeEventListener("dispose",O),P(C),et(C)}function V(){for(let C of p){let w=C.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):B(w))}p.clear(),u.clear()}function X(C){let w=n.get(C);if(w.__webglInit===void 0)return;let z=C.source,nt=f.get(z);if(nt){let Q=nt[w.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&H(C),Object.keys(nt).length===0&&f.delete(z)}n.remove(C)}function H(C){let w=n.get(C);i.deleteTexture(w.__webglTexture);let z=C.source,nt=f.get(z);delete nt[w.__cacheKey],o.memory.textures--}function et(C){let w=n.get(C);w.__depthDisposeCallback&&w.__depthDisposeCallback();let z=C.depthTexture;if(z&&z.renderTarget===C&&B(z),C.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(w.__webglFramebuffer[Q]))for(let at=0;at<w.__webglFramebuffer[Q].length;at++)i.deleteFramebuffer(w.__webglFramebuffer[Q][at]);else i.deleteFramebuffer(w.__webglFramebuffer[Q]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[Q])}else{if(Array.isArray(w.__webglFramebuffer))for(let Q=0;Q<w.__webglFramebuffer.length;Q++)i.deleteFramebuffer(w.__webglFramebuffer[Q]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let Q=0;Q<w.__webglColorRenderbuffer.length;Q++)w.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[Q]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let nt=C.textures;for(let Q=0,at=nt.length;Q<at;Q++){let dt=n.get(nt[Q]);dt.__webglTexture&&(i.deleteTexture(dt.__webglTexture),o.memory.textures--),n.remove(nt[Q])}n.remove(C)}let $=0;function J(){$=0}function tt(){return $}function wt(C){$=C}function Nt(){let C=$;return C>=s.maxTextures&&Dt("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,C}function Z(C){let w=[];return w.push(C.wrapS),w.push(C.wrapT),w.push(C.wrapR||0),w.push(C.magFilter),w.push(C.minFilter),w.push(C.anisotropy),w.push(C.internalFormat),w.push(C.format),w.push(C.type),w.push(C.generateMipmaps),w.push(C.mipmapsAutoUpdate),w.push(C.premultiplyAlpha),w.push(C.flipY),w.push(C.unpackAlignment),w.push(C.colorSpace),w.join()}function yt(C,w){let z=n.get(C);if(C.isVideoTexture&&Ie(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&z.__version!==C.version){let nt=C.image;if(nt===null)Dt("WebGLRenderer: Texture marked for update but no image data found.");else if(nt.complete===!1)Dt("WebGLRenderer: Texture marked for update but image is incomplete");else{Pe(z,C,w);return}}else C.isExternalTexture&&(z.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,z.__webglTexture,i.TEXTURE0+w)}function Tt(C,w){let z=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&z.__version!==C.version){Pe(z,C,w);return}else C.isExternalTexture&&(z.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,z.__webglTexture,i.TEXTURE0+w)}function kt(C,w){let z=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&z.__version!==C.version){Pe(z,C,w);return}e.bindTexture(i.TEXTURE_3D,z.__webglTexture,i.TEXTURE0+w)}function vt(C,w){let z=n.get(C);if(C.version>0&&z.__version!==C.version){_n(z,C,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,z.__webglTexture,i.TEXTURE0+w)}let Yt={[Cr]:i.REPEAT,[fi]:i.CLAMP_TO_EDGE,[lc]:i.MIRRORED_REPEAT},Ae={[Ve]:i.NEAREST,[Ng]:i.NEAREST_MIPMAP_NEAREST,[Ta]:i.NEAREST_MIPMAP_LINEAR,[pn]:i.LINEAR,[zc]:i.LINEAR_MIPMAP_NEAREST,[Oi]:i.LINEAR_MIPMAP_LINEAR},Ut={[Ug]:i.NEVER,[pf]:i.ALWAYS,[Bg]:i.LESS,[df]:i.LEQUAL,[zg]:i.EQUAL,[ff]:i.GEQUAL,[Gg]:i.GREATER,[Vg]:i.NOTEQUAL};function me(C,w){if(w.type===Xn&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===pn||w.magFilter===zc||w.magFilter===Ta||w.magFilter===Oi||w.minFilter===pn||w.minFilter===zc||w.minFilter===Ta||w.minFilter===Oi)&&Dt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,Yt[w.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Yt[w.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Yt[w.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,Ae[w.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,Ae[w.minFilter]),w.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Ut[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Ve||w.minFilter!==Ta&&w.minFilter!==Oi||w.type===Xn&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let z=t.get("EXT_texture_filter_anisotropic");i.texParameterf(C,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function xe(C,w){let z=!1;C.__webglInit===void 0&&(C.__webglInit=!0,w.addEventListener("dispose",k),D(w));let nt=w.source,Q=f.get(nt);Q===void 0&&(Q={},f.set(nt,Q));let at=Z(w);if(at!==C.__cacheKey){Q[at]===void 0&&(Q[at]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,z=!0),Q[at].usedTimes++;let dt=Q[C.__cacheKey];dt!==void 0&&(Q[C.__cacheKey].usedTimes--,dt.usedTimes===0&&H(w)),C.__cacheKey=at,C.__webglTexture=Q[at].texture}return z}function ee(C,w,z){return Math.floor(Math.floor(C/z)/w)}function We(C,w,z,nt){let at=C.updateRanges;if(at.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,z,nt,w.data);else{at.sort((L,K)=>L.start-K.start);let dt=0;for(let L=1;L<at.length;L++){let K=at[dt],q=at[L],ht=K.start+K.count,rt=ee(q.start,w.width,4),lt=ee(K.start,w.width,4);q.start<=ht+1&&rt===lt&&ee(q.start+q.count-1,w.width,4)===rt?K.count=Math.max(K.count,q.start+q.count-K.start):(++dt,at[dt]=q)}at.length=dt+1;let Y=e.getParameter(i.UNPACK_ROW_LENGTH),j=e.getParameter(i.UNPACK_SKIP_PIXELS),ct=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let L=0,K=at.length;L<K;L++){let q=at[L],ht=Math.floor(q.start/4),rt=Math.ceil(q.count/4),lt=ht%w.width,Pt=Math.floor(ht/w.width),Kt=rt,it=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,lt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Pt),e.texSubImage2D(i.TEXTURE_2D,0,lt,Pt,Kt,it,z,nt,w.data)}C.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,Y),e.pixelStorei(i.UNPACK_SKIP_PIXELS,j),e.pixelStorei(i.UNPACK_SKIP_ROWS,ct)}}function Pe(C,w,z){let nt=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(nt=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(nt=i.TEXTURE_3D);let Q=xe(C,w),at=w.source;e.bindTexture(nt,C.__webglTexture,i.TEXTURE0+z);let dt=n.get(at);if(at.version!==dt.__version||Q===!0){if(e.activeTexture(i.TEXTURE0+z),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let it=se.getPrimaries(se.workingColorSpace),It=w.colorSpace===Ui?null:se.getPrimaries(w.colorSpace),jt=w.colorSpace===Ui||it===It?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,jt)}e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let j=v(w.image,!1,s.maxTextureSize);j=Ot(w,j);let ct=r.convert(w.format,w.colorSpace),L=r.convert(w.type),K=R(w.internalFormat,ct,L,w.normalized,w.colorSpace,w.isVideoTexture);me(nt,w);let q,ht=w.mipmaps,rt=w.isVideoTexture!==!0,lt=dt.__version===void 0||Q===!0,Pt=at.dataReady,Kt=E(w,j);if(w.isDepthTexture)K=y(w.format===Fi,w.type),lt&&(rt?e.texStorage2D(i.TEXTURE_2D,1,K,j.width,j.height):e.texImage2D(i.TEXTURE_2D,0,K,j.width,j.height,0,ct,L,null));else if(w.isDataTexture)if(ht.length>0){rt&&lt&&e.texStorage2D(i.TEXTURE_2D,Kt,K,ht[0].width,ht[0].height);for(let it=0,It=ht.length;it<It;it++)q=ht[it],rt?Pt&&e.texSubImage2D(i.TEXTURE_2D,it,0,0,q.width,q.height,ct,L,q.data):e.texImage2D(i.TEXTURE_2D,it,K,q.width,q.height,0,ct,L,q.data);w.generateMipmaps=!1}else rt?(lt&&e.texStorage2D(i.TEXTURE_2D,Kt,K,j.width,j.height),Pt&&We(w,j,ct,L)):e.texImage2D(i.TEXTURE_2D,0,K,j.width,j.height,0,ct,L,j.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){rt&&lt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Kt,K,ht[0].width,ht[0].height,j.depth);for(let it=0,It=ht.length;it<It;it++)if(q=ht[it],w.format!==ri)if(ct!==null)if(rt){if(Pt)if(w.layerUpdates.size>0){let jt=Tf(q.width,q.height,w.format,w.type);for(let xt of w.layerUpdates){let ge=q.data.subarray(xt*jt/q.data.BYTES_PER_ELEMENT,(xt+1)*jt/q.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,it,0,0,xt,q.width,q.height,1,ct,ge)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,it,0,0,0,q.width,q.height,j.depth,ct,q.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,it,K,q.width,q.height,j.depth,0,q.data,0,0);else Dt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else rt?Pt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,it,0,0,0,q.width,q.height,j.depth,ct,L,q.data):e.texImage3D(i.TEXTURE_2D_ARRAY,it,K,q.width,q.height,j.depth,0,ct,L,q.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{rt&&lt&&e.texStorage2D(i.TEXTURE_2D,Kt,K,ht[0].width,ht[0].height);for(let it=0,It=ht.length;it<It;it++)q=ht[it],w.format!==ri?ct!==null?rt?Pt&&e.compressedTexSubImage2D(i.TEXTURE_2D,it,0,0,q.width,q.height,ct,q.data):e.compressedTexImage2D(i.TEXTURE_2D,it,K,q.width,q.height,0,q.data):Dt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):rt?Pt&&e.texSubImage2D(i.TEXTURE_2D,it,0,0,q.width,q.height,ct,L,q.data):e.texImage2D(i.TEXTURE_2D,it,K,q.width,q.height,0,ct,L,q.data)}else if(w.isDataArrayTexture)if(rt){if(lt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Kt,K,j.width,j.height,j.depth),Pt)if(w.layerUpdates.size>0){let it=Tf(j.width,j.height,w.format,w.type);for(let It of w.layerUpdates){let jt=j.data.subarray(It*it/j.data.BYTES_PER_ELEMENT,(It+1)*it/j.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,It,j.width,j.height,1,ct,L,jt)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,j.width,j.height,j.depth,ct,L,j.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,j.width,j.height,j.depth,0,ct,L,j.data);else if(w.isData3DTexture)rt?(lt&&e.texStorage3D(i.TEXTURE_3D,Kt,K,j.width,j.height,j.depth),Pt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,j.width,j.height,j.depth,ct,L,j.data)):e.texImage3D(i.TEXTURE_3D,0,K,j.width,j.height,j.depth,0,ct,L,j.data);else if(w.isFramebufferTexture){if(lt)if(rt)e.texStorage2D(i.TEXTURE_2D,Kt,K,j.width,j.height);else{let it=j.width,It=j.height;for(let jt=0;jt<Kt;jt++)e.texImage2D(i.TEXTURE_2D,jt,K,it,It,0,ct,L,null),it>>=1,It>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let it=i.canvas;if(it.hasAttribute("layoutsubtree")||it.setAttribute("layoutsubtree","true"),j.parentNode!==it){it.appendChild(j),u.add(w),it.onpaint=It=>{let jt=It.changedElements;for(let xt of u)jt.includes(xt.image)&&(xt.needsUpdate=!0)},it.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,j);else{let jt=i.RGBA,xt=i.RGBA,ge=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,jt,xt,ge,j)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ht.length>0){if(rt&&lt){let it=$t(ht[0]);e.texStorage2D(i.TEXTURE_2D,Kt,K,it.width,it.height)}for(let it=0,It=ht.length;it<It;it++)q=ht[it],rt?Pt&&e.texSubImage2D(i.TEXTURE_2D,it,0,0,ct,L,q):e.texImage2D(i.TEXTURE_2D,it,K,ct,L,q);w.generateMipmaps=!1}else if(rt){if(lt){let it=$t(j);e.texStorage2D(i.TEXTURE_2D,Kt,K,it.width,it.height)}Pt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ct,L,j)}else e.texImage2D(i.TEXTURE_2D,0,K,ct,L,j);S(w)&&w.mipmapsAutoUpdate===!0&&b(nt),dt.__version=at.version,w.onUpdate&&w.onUpdate(w)}C.__version=w.version}function _n(C,w,z){if(w.image.length!==6)return;let nt=xe(C,w),Q=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+z);let at=n.get(Q);if(Q.version!==at.__version||nt===!0){e.activeTexture(i.TEXTURE0+z);let dt=se.getPrimaries(se.workingColorSpace),Y=w.colorSpace===Ui?null:se.getPrimaries(w.colorSpace),j=w.colorSpace===Ui||dt===Y?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,j);let ct=w.isCompressedTexture||w.image[0].isCompressedTexture,L=w.image[0]&&w.image[0].isDataTexture,K=[];for(let xt=0;xt<6;xt++)!ct&&!L?K[xt]=v(w.image[xt],!0,s.maxCubemapSize):K[xt]=L?w.image[xt].image:w.image[xt],K[xt]=Ot(w,K[xt]);let q=K[0],ht=r.convert(w.format,w.colorSpace),rt=r.convert(w.type),lt=R(w.internalFormat,ht,rt,w.normalized,w.colorSpace),Pt=w.isVideoTexture!==!0,Kt=at.__version===void 0||nt===!0,it=Q.dataReady,It=E(w,q);me(i.TEXTURE_CUBE_MAP,w);let jt;if(w.isDepthTexture){if(lt=y(w.format===Fi,w.type),Kt)if(Pt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,lt,q.width,q.height);else for(let xt=0;xt<6;xt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,0,lt,q.width,q.height,0,ht,rt,null)}else if(ct){Pt&&Kt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,It,lt,q.width,q.height);for(let xt=0;xt<6;xt++){jt=K[xt].mipmaps;for(let ge=0;ge<jt.length;ge++){let Be=jt[ge];w.format!==ri?ht!==null?Pt?it&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,ge,0,0,Be.width,Be.height,ht,Be.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,ge,lt,Be.width,Be.height,0,Be.data):Dt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Pt?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,ge,0,0,Be.width,Be.height,ht,rt,Be.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,ge,lt,Be.width,Be.height,0,ht,rt,Be.data)}}}else{if(jt=w.mipmaps,Pt&&Kt){jt.length>0&&It++;let xt=$t(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,It,lt,xt.width,xt.height)}for(let xt=0;xt<6;xt++)if(L){Pt?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,0,0,0,K[xt].width,K[xt].height,ht,rt,K[xt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,0,lt,K[xt].width,K[xt].height,0,ht,rt,K[xt].data);for(let ge=0;ge<jt.length;ge++){let Yi=jt[ge].image[xt].image;Pt?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,ge+1,0,0,Yi.width,Yi.height,ht,rt,Yi.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,ge+1,lt,Yi.width,Yi.height,0,ht,rt,Yi.data)}}else{Pt?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,0,0,0,ht,rt,K[xt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,0,lt,ht,rt,K[xt]);for(let ge=0;ge<jt.length;ge++){let Be=jt[ge];Pt?it&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,ge+1,0,0,ht,rt,Be.image[xt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,ge+1,lt,ht,rt,Be.image[xt])}}}S(w)&&w.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),at.__version=Q.version,w.onUpdate&&w.onUpdate(w)}C.__version=w.version}function Se(C,w,z,nt,Q,at){let dt=r.convert(z.format,z.colorSpace),Y=r.convert(z.type),j=R(z.internalFormat,dt,Y,z.normalized,z.colorSpace),ct=n.get(w),L=n.get(z);if(L.__renderTarget=w,!ct.__hasExternalTextures){let K=Math.max(1,w.width>>at),q=Math.max(1,w.height>>at);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?e.texImage3D(Q,at,j,K,q,w.depth,0,dt,Y,null):e.texImage2D(Q,at,j,K,q,0,dt,Y,null)}e.bindFramebuffer(i.FRAMEBUFFER,C),mt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,nt,Q,L.__webglTexture,0,Me(w)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,nt,Q,L.__webglTexture,at),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ci(C,w,z){if(i.bindRenderbuffer(i.RENDERBUFFER,C),w.depthBuffer){let nt=w.depthTexture,Q=nt&&nt.isDepthTexture?nt.type:null,at=y(w.stencilBuffer,Q),dt=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;mt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Me(w),at,w.width,w.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Me(w),at,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,at,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,dt,i.RENDERBUFFER,C)}else{let nt=w.textures;for(let Q=0;Q<nt.length;Q++){let at=nt[Q],dt=r.convert(at.format,at.colorSpace),Y=r.convert(at.type),j=R(at.internalFormat,dt,Y,at.normalized,at.colorSpace);mt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Me(w),j,w.width,w.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Me(w),j,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,j,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ue(C,w,z){let nt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,C),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(w.depthTexture);Q.__renderTarget=w;let at=nt?w.depthTexture.image[0]:w.depthTexture.image;(!Q.__webglTexture||at.width!==w.width||at.height!==w.height)&&(at.width=w.width,at.height=w.height,w.depthTexture.needsUpdate=!0),nt?vt(w.depthTexture,0):yt(w.depthTexture,0);let dt=Q.__webglTexture,Y=Me(w),j=nt?i.TEXTURE_CUBE_MAP_POSITIVE_X+z:i.TEXTURE_2D,ct=w.depthTexture.format===Fi?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ii)mt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ct,j,dt,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,ct,j,dt,0);else if(w.depthTexture.format===Fi)mt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ct,j,dt,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,ct,j,dt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Fn(C){let w=n.get(C),z=C.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==C.depthTexture){let nt=C.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),nt){let Q=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,nt.removeEventListener("dispose",Q)};nt.addEventListener("dispose",Q),w.__depthDisposeCallback=Q}w.__boundDepthTexture=nt}if(C.depthTexture&&!w.__autoAllocateDepthBuffer)if(z)for(let nt=0;nt<6;nt++)Ue(w.__webglFramebuffer[nt],C,nt);else C.texture.mipmaps.length>0?Ue(w.__webglFramebuffer[0],C,0):Ue(w.__webglFramebuffer,C,0);else if(z){w.__webglDepthbuffer=[];for(let nt=0;nt<6;nt++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[nt]),w.__webglDepthbuffer[nt]===void 0)w.__webglDepthbuffer[nt]=i.createRenderbuffer(),ci(w.__webglDepthbuffer[nt],C,!1);else{let Q=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,at=w.__webglDepthbuffer[nt];i.bindRenderbuffer(i.RENDERBUFFER,at),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,at)}}else if(C.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),ci(w.__webglDepthbuffer,C,!1);else{let Q=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,at=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,at),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,at)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Un(C,w,z){let nt=n.get(C);w!==void 0&&Se(nt.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),z!==void 0&&Fn(C)}function Bn(C){let w=C.texture,z=n.get(C),nt=n.get(w);C.addEventListener("dispose",O),D(C);let Q=C.textures,at=C.isWebGLCubeRenderTarget===!0,dt=Q.length>1;if(dt||(nt.__webglTexture===void 0&&(nt.__webglTexture=i.createTexture()),nt.__version=w.version,o.memory.textures++),at){z.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(w.mipmaps.length>0){z.__webglFramebuffer[Y]=[];for(let j=0;j<w.mipmaps.length;j++)z.__webglFramebuffer[Y][j]=i.createFramebuffer()}else z.__webglFramebuffer[Y]=i.createFramebuffer()}else{if(w.mipmaps.length>0){z.__webglFramebuffer=[];for(let Y=0;Y<w.mipmaps.length;Y++)z.__webglFramebuffer[Y]=i.createFramebuffer()}else z.__webglFramebuffer=i.createFramebuffer();if(dt)for(let Y=0,j=Q.length;Y<j;Y++){let ct=n.get(Q[Y]);ct.__webglTexture===void 0&&(ct.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&mt(C)===!1){z.__webglMultisampledFramebuffer=i.createFramebuffer(),z.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let Y=0;Y<Q.length;Y++){let j=Q[Y];z.__webglColorRenderbuffer[Y]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,z.__webglColorRenderbuffer[Y]);let ct=r.convert(j.format,j.colorSpace),L=r.convert(j.type),K=R(j.internalFormat,ct,L,j.normalized,j.colorSpace,C.isXRRenderTarget===!0),q=Me(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,q,K,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Y,i.RENDERBUFFER,z.__webglColorRenderbuffer[Y])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(z.__webglDepthRenderbuffer=i.createRenderbuffer(),ci(z.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(at){e.bindTexture(i.TEXTURE_CUBE_MAP,nt.__webglTexture),me(i.TEXTURE_CUBE_MAP,w);for(let Y=0;Y<6;Y++)if(w.mipmaps.length>0)for(let j=0;j<w.mipmaps.length;j++)Se(z.__webglFramebuffer[Y][j],C,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,j);else Se(z.__webglFramebuffer[Y],C,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);S(w)?b(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(dt){for(let Y=0,j=Q.length;Y<j;Y++){let ct=Q[Y],L=n.get(ct),K=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(K=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,L.__webglTexture),me(K,ct),Se(z.__webglFramebuffer,C,ct,i.COLOR_ATTACHMENT0+Y,K,0),S(ct)&&b(K)}e.unbindTexture()}else{let Y=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Y=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Y,nt.__webglTexture),me(Y,w),w.mipmaps.length>0)for(let j=0;j<w.mipmaps.length;j++)Se(z.__webglFramebuffer[j],C,w,i.COLOR_ATTACHMENT0,Y,j);else Se(z.__webglFramebuffer,C,w,i.COLOR_ATTACHMENT0,Y,0);S(w)?b(Y):w.mipmaps.length>0&&i.texParameteri(Y,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}C.depthBuffer&&Fn(C)}function F(C){let w=C.textures;for(let z=0,nt=w.length;z<nt;z++){let Q=w[z];if(S(Q)&&Q.mipmapsAutoUpdate===!0){let at=T(C),dt=n.get(Q).__webglTexture;e.bindTexture(at,dt),b(at),e.unbindTexture()}}}let zn=[];function we(C){if(C.samples>0){if(mt(C)===!1){let w=C.textures,z=C.width,nt=C.height,Q=i.COLOR_BUFFER_BIT,at=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,dt=n.get(C),Y=w.length>1;if(Y)for(let ct=0;ct<w.length;ct++)e.bindFramebuffer(i.FRAMEBUFFER,dt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,dt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,dt.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,dt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,dt.__webglFramebuffer);for(let ct=0;ct<w.length;ct++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),Y){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,dt.__webglColorRenderbuffer[ct]);let L=n.get(w[ct]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,L,0)}i.blitFramebuffer(0,0,z,nt,0,0,z,nt,Q,i.NEAREST),l===!0&&(zn.length=0,zn.push(i.COLOR_ATTACHMENT0+ct),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&zn.push(at),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,zn))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Y)for(let ct=0;ct<w.length;ct++){e.bindFramebuffer(i.FRAMEBUFFER,dt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.RENDERBUFFER,dt.__webglColorRenderbuffer[ct]);let L=n.get(w[ct]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,dt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.TEXTURE_2D,L,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,dt.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let w=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function Me(C){return Math.min(s.maxSamples,C.samples)}function mt(C){let w=n.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Ie(C){let w=o.render.frame;h.get(C)!==w&&(h.set(C,w),C.update())}function Ot(C,w){let z=C.colorSpace,nt=C.format,Q=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||z!==Go&&z!==Ui&&(se.getTransfer(z)===fe?(nt!==ri||Q!==Mn)&&Dt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Bt("WebGLTextures: Unsupported texture color space:",z)),w}function $t(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=Nt,this.resetTextureUnits=J,this.getTextureUnits=tt,this.setTextureUnits=wt,this.setTexture2D=yt,this.setTexture2DArray=Tt,this.setTexture3D=kt,this.setTextureCube=vt,this.rebindTextures=Un,this.setupRenderTarget=Bn,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=we,this.setupDepthRenderbuffer=Fn,this.setupFrameBufferTexture=Se,this.useMultisampledRTT=mt,this.dispose=V}function K1(i,t){function e(n,s=Ui){let r,o=se.getTransfer(s);if(n===Mn)return i.UNSIGNED_BYTE;if(n===Vc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Hc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===lf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===cf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===of)return i.BYTE;if(n===af)return i.SHORT;if(n===Yr)return i.UNSIGNED_SHORT;if(n===Gc)return i.INT;if(n===ii)return i.UNSIGNED_INT;if(n===Xn)return i.FLOAT;if(n===si)return i.HALF_FLOAT;if(n===hf)return i.ALPHA;if(n===uf)return i.RGB;if(n===ri)return i.RGBA;if(n===Ii)return i.DEPTH_COMPONENT;if(n===Fi)return i.DEPTH_STENCIL;if(n===Wc)return i.RED;if(n===$c)return i.RED_INTEGER;if(n===ds)return i.RG;if(n===Xc)return i.RG_INTEGER;if(n===qc)return i.RGBA_INTEGER;if(n===Ea||n===Aa||n===Ra||n===Ca)if(o===fe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ea)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ea)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Aa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ra)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ca)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Yc||n===Zc||n===jc||n===Kc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Yc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Zc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Kc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Jc||n===Qc||n===th||n===eh||n===nh||n===Pa||n===ih)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Jc||n===Qc)return o===fe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===th)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===eh)return r.COMPRESSED_R11_EAC;if(n===nh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Pa)return r.COMPRESSED_RG11_EAC;if(n===ih)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===dh||n===fh||n===ph||n===mh||n===gh||n===xh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===sh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===rh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===oh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ah)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===lh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ch)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===hh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===uh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===dh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===fh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===ph)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===mh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===gh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===xh)return o===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===yh||n===vh||n===bh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===yh)return o===fe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===bh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===_h||n===wh||n===Ia||n===Mh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===_h)return r.COMPRESSED_RED_RGTC1_EXT;if(n===wh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ia)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Mh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Gs?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var J1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Q1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Nf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ta(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new $n({vertexShader:J1,fragmentShader:Q1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new ae(new Ns(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},kf=class extends ti{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new Nf,g={},v=e.getContextAttributes(),S=null,b=null,T=[],R=[],y=new st,E=null,D=null,P=new fn;P.viewport=new pe;let k=new fn;k.viewport=new pe;let O=[P,k],B=new Fc,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let yt=T[Z];return yt===void 0&&(yt=new Nr,T[Z]=yt),yt.getTargetRaySpace()},this.getControllerGrip=function(Z){let yt=T[Z];return yt===void 0&&(yt=new Nr,T[Z]=yt),yt.getGripSpace()},this.getHand=function(Z){let yt=T[Z];return yt===void 0&&(yt=new Nr,T[Z]=yt),yt.getHandSpace()};function X(Z){let yt=R.indexOf(Z.inputSource);if(yt===-1)return;let Tt=T[yt];Tt!==void 0&&(Tt.update(Z.inputSource,Z.frame,c||o),Tt.dispatchEvent({type:Z.type,data:Z.inputSource}))}function H(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",et);for(let Z=0;Z<T.length;Z++){let yt=R[Z];yt!==null&&(R[Z]=null,T[Z].disconnect(yt))}I=null,V=null,m.reset();for(let Z in g)delete g[Z];if(t.setRenderTarget(S),f=null,d=null,u=null,s=null,b=null,Nt.stop(),n.isPresenting=!1,t.setPixelRatio(E),t.setSize(y.width,y.height,!1),D!==null){let Z=D.camera;Z.fov=D.fov,Z.zoom=D.zoom,Z.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,n.isPresenting===!0&&Dt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,n.isPresenting===!0&&Dt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",H),s.addEventListener("inputsourceschange",et),v.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let Tt=null,kt=null,vt=null;v.depth&&(vt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Tt=v.stencil?Fi:Ii,kt=v.stencil?Gs:ii);let Yt={colorFormat:e.RGBA8,depthFormat:vt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Yt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new In(d.textureWidth,d.textureHeight,{format:ri,type:Mn,depthTexture:new Di(d.textureWidth,d.textureHeight,kt,void 0,void 0,void 0,void 0,void 0,void 0,Tt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Tt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,Tt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new In(f.framebufferWidth,f.framebufferHeight,{format:ri,type:Mn,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Nt.setContext(s),Nt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function et(Z){for(let yt=0;yt<Z.removed.length;yt++){let Tt=Z.removed[yt],kt=R.indexOf(Tt);kt>=0&&(R[kt]=null,T[kt].disconnect(Tt))}for(let yt=0;yt<Z.added.length;yt++){let Tt=Z.added[yt],kt=R.indexOf(Tt);if(kt===-1){for(let Yt=0;Yt<T.length;Yt++)if(Yt>=R.length){R.push(Tt),kt=Yt;break}else if(R[Yt]===null){R[Yt]=Tt,kt=Yt;break}if(kt===-1)break}let vt=T[kt];vt&&vt.connect(Tt)}}function $(Z,yt){yt===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(yt.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let yt=Z.near,Tt=Z.far;m.texture!==null&&(m.depthNear>0&&(yt=m.depthNear),m.depthFar>0&&(Tt=m.depthFar)),B.near=k.near=P.near=yt,B.far=k.far=P.far=Tt,(I!==B.near||V!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),I=B.near,V=B.far),B.layers.mask=Z.layers.mask|6,P.layers.mask=B.layers.mask&-5,k.layers.mask=B.layers.mask&-3;let kt=Z.parent,vt=B.cameras;$(B,kt);for(let Yt=0;Yt<vt.length;Yt++)$(vt[Yt],kt);B.projectionMatrix.copy(P.projectionMatrix),B.projectionMatrixInverse.copy(P.projectionMatrixInverse),D===null&&Z.isPerspectiveCamera&&(D={camera:Z,fov:Z.fov,zoom:Z.zoom}),J(Z,B,kt)};function J(Z,yt,Tt){Tt===null?Z.matrix.copy(yt.matrixWorld):(Z.matrix.copy(Tt.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(yt.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(yt.projectionMatrix),Z.projectionMatrixInverse.copy(yt.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=Lr*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Z){l=Z,d!==null&&(d.fixedFoveation=Z),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Z)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(Z){return g[Z]};let tt=null;function wt(Z,yt){if(h=yt.getViewerPose(c||o),p=yt,h!==null){let Tt=h.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let kt=!1;Tt.length!==B.cameras.length&&(B.cameras.length=0,kt=!0);for(let Ut=0;Ut<Tt.length;Ut++){let me=Tt[Ut],xe=null;if(f!==null)xe=f.getViewport(me);else{let We=u.getViewSubImage(d,me);xe=We.viewport,Ut===0&&(t.setRenderTargetTextures(b,We.colorTexture,We.depthStencilTexture),t.setRenderTarget(b))}let ee=O[Ut];ee===void 0&&(ee=new fn,ee.layers.enable(Ut),ee.viewport=new pe,O[Ut]=ee),ee.matrix.fromArray(me.transform.matrix),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.projectionMatrix.fromArray(me.projectionMatrix),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert(),ee.viewport.set(xe.x,xe.y,xe.width,xe.height),Ut===0&&(B.matrix.copy(ee.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),kt===!0&&B.cameras.push(ee)}let vt=s.enabledFeatures;if(vt&&vt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Ut=u.getDepthInformation(Tt[0]);Ut&&Ut.isValid&&Ut.texture&&m.init(Ut,s.renderState)}if(vt&&vt.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Ut=0;Ut<Tt.length;Ut++){let me=Tt[Ut].camera;if(me){let xe=g[me];xe||(xe=new ta,g[me]=xe);let ee=u.getCameraImage(me);xe.sourceTexture=ee}}}}for(let Tt=0;Tt<T.length;Tt++){let kt=R[Tt],vt=T[Tt];kt!==null&&vt!==void 0&&vt.update(kt,yt,c||o)}tt&&tt(Z,yt),yt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:yt}),p=null}let Nt=new w0;Nt.setAnimationLoop(wt),this.setAnimationLoop=function(Z){tt=Z},this.dispose=function(){}}},tT=new Lt,L0=new Wt;L0.set(-1,0,0,0,1,0,0,0,1);function eT(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,wf(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,v,S,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,v,S):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===gn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===gn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let v=t.get(g),S=v.envMap,b=v.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(tT.makeRotationFromEuler(b)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(L0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,v,S){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*v,m.scale.value=S*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,v){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===gn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let v=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function nT(i,t,e,n){let s={},r={};function o(v,S){let b=S.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,S){let b=s[v.id];b===void 0&&(p(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",m));let T=S.program;n.updateUBOMapping(v,T);let R=t.render.frame;r[v.id]!==R&&(c(v),r[v.id]=R)}function l(v){let S=i.createBuffer(),b=v.__size,T=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,S),i.bufferData(i.UNIFORM_BUFFER,b,T),i.bindBuffer(i.UNIFORM_BUFFER,null),S}function c(v){let S=s[v.id],b=v.uniforms,T=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let R=0,y=b.length;R<y;R++){let E=b[R];if(Array.isArray(E))for(let D=0,P=E.length;D<P;D++)h(E[D],R,D,T);else h(E,R,0,T)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,S,b,T){if(d(v,S,b,T)===!0){let R=v.__offset,y=v.value;if(Array.isArray(y)){let E=0;for(let D=0;D<y.length;D++){let P=y[D],k=x(P,!0);u(P,v.__data,E),E+=k.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,R,v.__data)}}function u(v,S,b){typeof v=="number"||typeof v=="boolean"?S[b]=v:v.isMatrix3?(S[b]=v.elements[0],S[b+1]=v.elements[1],S[b+2]=v.elements[2],S[b+3]=0,S[b+4]=v.elements[3],S[b+5]=v.elements[4],S[b+6]=v.elements[5],S[b+7]=0,S[b+8]=v.elements[6],S[b+9]=v.elements[7],S[b+10]=v.elements[8],S[b+11]=0):ArrayBuffer.isView(v)?S.set(v.subarray(0,S.length-b),b):v.toArray(S,b)}function d(v,S,b,T){let R=v.value,y=S+"_"+b;if(Array.isArray(R)){T[y]===void 0&&(T[y]=[]);let E=T[y],D=!1;for(let P=0;P<R.length;P++)f(R[P],E,P)===!0&&(D=!0);return D}return f(R,T,y)}function f(v,S,b){if(S[b]===void 0)return typeof v=="number"||typeof v=="boolean"?S[b]=v:ArrayBuffer.isView(v)?S[b]=v.slice():S[b]=v.clone(),!0;{let T=S[b];if(typeof v=="number"||typeof v=="boolean"){if(T!==v)return S[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(T.equals(v)===!1)return T.copy(v),!0}}return!1}function p(v){let S=v.uniforms,b=0,T=16;for(let y=0,E=S.length;y<E;y++){let D=Array.isArray(S[y])?S[y]:[S[y]];for(let P=0,k=D.length;P<k;P++){let O=D[P],B=Array.isArray(O.value)?O.value:[O.value],I=Array.isArray(S[y])||Array.isArray(O.value),V=b;for(let H=0,et=B.length;H<et;H++){let $=B[H],J=x($,I),tt=b%T,wt=tt%J.boundary,Nt=tt+wt;b+=wt,Nt!==0&&T-Nt<J.storage&&(b+=T-Nt),H===0&&(V=b),b+=J.storage}let X=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new X((b-V)/Float32Array.BYTES_PER_ELEMENT),O.__offset=V}}let R=b%T;return R>0&&(b+=T-R),v.__size=b,v.__cache={},this}function x(v,S){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?Dt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):Dt("WebGLRenderer: Unsupported uniform value type.",v),S===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(v){let S=v.target;S.removeEventListener("dispose",m),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function g(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var iT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),xi=null;function sT(){return xi===null&&(xi=new jo(iT,16,16,ds,si),xi.name="DFG_LUT",xi.minFilter=pn,xi.magFilter=pn,xi.wrapS=fi,xi.wrapT=fi,xi.generateMipmaps=!1,xi.needsUpdate=!0),xi}var Rh=class{constructor(t={}){let{canvas:e=Hg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Mn}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,m=new Set([qc,Xc,$c]),g=new Set([Mn,ii,Yr,Gs,Vc,Hc]),v=new Uint32Array(4),S=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},T=null,R=null,y=[],E=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=gi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,k=!1,O=null,B=null,I=null,V=null;this._outputColorSpace=qe;let X=0,H=0,et=null,$=-1,J=null,tt=new pe,wt=new pe,Nt=null,Z=new Mt(0),yt=0,Tt=e.width,kt=e.height,vt=1,Yt=null,Ae=null,Ut=new pe(0,0,Tt,kt),me=new pe(0,0,Tt,kt),xe=!1,ee=new is,We=new fc,Pe=!1,_n=!1,Se=new Lt,ci=new A,Ue=new pe,Fn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Un=!1;function Bn(){return et===null?vt:1}let F=n;function zn(M,N){return e.getContext(M,N)}let we,Me,mt,Ie,Ot,$t,C,w,z,nt,Q,at,dt,Y,j,ct,L,K,q,ht,rt,lt,Pt;try{let M={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",It,!1),e.addEventListener("webglcontextrestored",jt,!1),e.addEventListener("webglcontextcreationerror",xt,!1),F===null){let N="webgl2";if(F=zn(N,M),F===null)throw zn(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Kt()}catch(M){throw e.removeEventListener("webglcontextlost",It,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",xt,!1),Bt("WebGLRenderer: "+M.message),M}function Kt(){we=new mS(F),we.init(),rt=new K1(F,we),Me=new sS(F,we,t,rt),mt=new Z1(F,we),Me.reversedDepthBuffer&&d&&mt.buffers.depth.setReversed(!0),B=F.createFramebuffer(),I=F.createFramebuffer(),V=F.createFramebuffer(),Ie=new yS(F),Ot=new k1,$t=new j1(F,we,mt,Ot,Me,rt,Ie),C=new pS(P),w=new b_(F),lt=new nS(F,w),z=new gS(F,w,Ie,lt),nt=new bS(F,z,w,lt,Ie),K=new vS(F,Me,$t),j=new rS(Ot),Q=new N1(P,C,we,Me,lt,j),at=new eT(P,Ot),dt=new F1,Y=new H1(we),L=new eS(P,C,mt,nt,p,l),ct=new Y1(P,nt,Me),Pt=new nT(F,Ie,Me,mt),q=new iS(F,we,Ie),ht=new xS(F,we,Ie),Ie.programs=Q.programs,P.capabilities=Me,P.extensions=we,P.properties=Ot,P.renderLists=dt,P.shadowMap=ct,P.state=mt,P.info=Ie}x!==Mn&&(D=new wS(x,e.width,e.height,a,s,r));let it=new kf(P,F);this.xr=it,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let M=we.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=we.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return vt},this.setPixelRatio=function(M){M!==void 0&&(vt=M,this.setSize(Tt,kt,!1))},this.getSize=function(M){return M.set(Tt,kt)},this.setSize=function(M,N,W=!0){if(it.isPresenting){Dt("WebGLRenderer: Can't change size while VR device is presenting.");return}Tt=M,kt=N,e.width=Math.floor(M*vt),e.height=Math.floor(N*vt),W===!0&&(e.style.width=M+"px",e.style.height=N+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,M,N)},this.getDrawingBufferSize=function(M){return M.set(Tt*vt,kt*vt).floor()},this.setDrawingBufferSize=function(M,N,W){Tt=M,kt=N,vt=W,e.width=Math.floor(M*W),e.height=Math.floor(N*W),this.setViewport(0,0,M,N)},this.setEffects=function(M){if(x===Mn){Bt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let N=0;N<M.length;N++)if(M[N].isOutputPass===!0){Dt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(tt)},this.getViewport=function(M){return M.copy(Ut)},this.setViewport=function(M,N,W,U){M.isVector4?Ut.set(M.x,M.y,M.z,M.w):Ut.set(M,N,W,U),mt.viewport(tt.copy(Ut).multiplyScalar(Bn()).round())},this.getScissor=function(M){return M.copy(me)},this.setScissor=function(M,N,W,U){M.isVector4?me.set(M.x,M.y,M.z,M.w):me.set(M,N,W,U),mt.scissor(wt.copy(me).multiplyScalar(Bn()).round())},this.getScissorTest=function(){return xe},this.setScissorTest=function(M){mt.setScissorTest(xe=M)},this.setOpaqueSort=function(M){Yt=M},this.setTransparentSort=function(M){Ae=M},this.getClearColor=function(M){return M.copy(L.getClearColor())},this.setClearColor=function(){L.setClearColor(...arguments)},this.getClearAlpha=function(){return L.getClearAlpha()},this.setClearAlpha=function(){L.setClearAlpha(...arguments)},this.clear=function(M=!0,N=!0,W=!0){let U=0;if(M){let G=!1;if(et!==null){let ft=et.texture.format;G=m.has(ft)}if(G){let ft=et.texture.type,St=g.has(ft),ut=L.getClearColor(),bt=L.getClearAlpha(),Rt=ut.r,qt=ut.g,ne=ut.b;St?(v[0]=Rt,v[1]=qt,v[2]=ne,v[3]=bt,F.clearBufferuiv(F.COLOR,0,v)):(S[0]=Rt,S[1]=qt,S[2]=ne,S[3]=bt,F.clearBufferiv(F.COLOR,0,S))}else U|=F.COLOR_BUFFER_BIT}N&&(U|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),W&&(U|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&F.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),O=M},this.dispose=function(){e.removeEventListener("webglcontextlost",It,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",xt,!1),L.dispose(),dt.dispose(),Y.dispose(),$t.dispose(),Ot.dispose(),C.dispose(),nt.dispose(),z.dispose(),lt.dispose(),Pt.dispose(),Q.dispose(),it.dispose(),it.removeEventListener("sessionstart",nm),it.removeEventListener("sessionend",im),Ms.stop()};function It(M){M.preventDefault(),Wo("WebGLRenderer: Context Lost."),k=!0}function jt(){Wo("WebGLRenderer: Context Restored."),k=!1;let M=Ie.autoReset,N=ct.enabled,W=ct.autoUpdate,U=ct.needsUpdate,G=ct.type;Kt(),Ie.autoReset=M,ct.enabled=N,ct.autoUpdate=W,ct.needsUpdate=U,ct.type=G}function xt(M){Bt("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function ge(M){let N=M.target;N.removeEventListener("dispose",ge),Be(N)}function Be(M){Yi(M),Ot.remove(M)}function Yi(M){let N=Ot.get(M).programs;N!==void 0&&(N.forEach(function(W){Q.releaseProgram(W)}),M.isShaderMaterial&&Q.releaseShaderCache(M))}this.renderBufferDirect=function(M,N,W,U,G,ft){N===null&&(N=Fn);let St=G.isMesh&&G.matrixWorld.determinantAffine()<0,ut=yv(M,N,W,U,G);mt.setMaterial(U,St);let bt=W.index,Rt=1;if(U.wireframe===!0){if(bt=z.getWireframeAttribute(W),bt===void 0)return;Rt=2}let qt=W.drawRange,ne=W.attributes.position,Et=qt.start*Rt,ie=(qt.start+qt.count)*Rt;ft!==null&&(Et=Math.max(Et,ft.start*Rt),ie=Math.min(ie,(ft.start+ft.count)*Rt)),bt!==null?(Et=Math.max(Et,0),ie=Math.min(ie,bt.count)):ne!=null&&(Et=Math.max(Et,0),ie=Math.min(ie,ne.count));let Re=ie-Et;if(Re<0||Re===1/0)return;lt.setup(G,U,ut,W,bt);let be,ye=q;if(bt!==null&&(be=w.get(bt),ye=ht,ye.setIndex(be)),G.isMesh)U.wireframe===!0?(mt.setLineWidth(U.wireframeLinewidth*Bn()),ye.setMode(F.LINES)):ye.setMode(F.TRIANGLES);else if(G.isLine){let tn=U.linewidth;tn===void 0&&(tn=1),mt.setLineWidth(tn*Bn()),G.isLineSegments?ye.setMode(F.LINES):G.isLineLoop?ye.setMode(F.LINE_LOOP):ye.setMode(F.LINE_STRIP)}else G.isPoints?ye.setMode(F.POINTS):G.isSprite&&ye.setMode(F.TRIANGLES);if(G.isBatchedMesh)if(we.get("WEBGL_multi_draw"))ye.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let tn=G._multiDrawStarts,At=G._multiDrawCounts,un=G._multiDrawCount,he=bt?w.get(bt).bytesPerElement:1,Ss=Ot.get(U).currentProgram.getUniforms();for(let en=0;en<un;en++)Ss.setValue(F,"_gl_DrawID",en),ye.render(tn[en]/he,At[en])}else if(G.isInstancedMesh)ye.renderInstances(Et,Re,G.count);else if(W.isInstancedBufferGeometry){let tn=W._maxInstanceCount!==void 0?W._maxInstanceCount:1/0,At=Math.min(W.instanceCount,tn);ye.renderInstances(Et,Re,At)}else ye.render(Et,Re)};function em(M,N,W,U){O!==null&&M.isNodeMaterial&&O.setObject(U,M),Pe===!0&&j.setState(M,W,!1),M.transparent===!0&&M.side===cn&&M.forceSinglePass===!1?(M.side=gn,M.needsUpdate=!0,vo(M,N,U),M.side=us,M.needsUpdate=!0,vo(M,N,U),M.side=cn):vo(M,N,U)}this.compile=function(M,N,W=null){W===null&&(W=M),O!==null&&O.renderStart(M,N,W),R=Y.get(W),R.init(N),E.push(R),W.traverseVisible(function(G){G.isLight&&G.layers.test(N.layers)&&(R.pushLight(G),G.castShadow&&R.pushShadow(G))}),M!==W&&M.traverseVisible(function(G){G.isLight&&G.layers.test(N.layers)&&(R.pushLight(G),G.castShadow&&R.pushShadow(G))}),R.setupLights(),O!==null&&O.updateLights(R.state.lightsArray),_n=this.localClippingEnabled,Pe=j.init(this.clippingPlanes,_n),Pe===!0&&j.setGlobalState(this.clippingPlanes,N),O!==null&&ct.render(R.state.shadowsArray,W,N);let U=new Set;return M.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;let ft=G.material;if(ft)if(Array.isArray(ft))for(let St=0;St<ft.length;St++){let ut=ft[St];em(ut,W,N,G),U.add(ut)}else em(ft,W,N,G),U.add(ft)}),R=E.pop(),O!==null&&O.renderEnd(),U},this.compileAsync=function(M,N,W=null){let U=this.compile(M,N,W);return new Promise(G=>{function ft(){if(U.forEach(function(St){let bt=Ot.get(St).currentProgram;(bt===void 0||bt.isReady())&&U.delete(St)}),U.size===0){G(M);return}setTimeout(ft,10)}we.get("KHR_parallel_shader_compile")!==null?ft():setTimeout(ft,10)})};let id=null;function gv(M){id&&id(M)}function nm(){Ms.stop()}function im(){Ms.start()}let Ms=new w0;Ms.setAnimationLoop(gv),typeof self<"u"&&Ms.setContext(self),this.setAnimationLoop=function(M){id=M,it.setAnimationLoop(M),M===null?Ms.stop():Ms.start()},it.addEventListener("sessionstart",nm),it.addEventListener("sessionend",im),this.render=function(M,N){if(N!==void 0&&N.isCamera!==!0){Bt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(k===!0)return;O!==null&&O.renderStart(M,N);let W=it.enabled===!0&&it.isPresenting===!0,U=D!==null&&(et===null||W)&&D.begin(P,et);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(it.cameraAutoUpdate===!0&&it.updateCamera(N),N=it.getCamera()),M.isScene===!0&&M.onBeforeRender(P,M,N,et),R=Y.get(M,E.length),R.init(N),R.state.textureUnits=$t.getTextureUnits(),E.push(R),Se.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?We.setFromArrayCamera(N):ee.setFromProjectionMatrix(Se,Hn,N.reversedDepth),_n=this.localClippingEnabled,Pe=j.init(this.clippingPlanes,_n),T=dt.get(M,y.length),T.init(),y.push(T),this.info.render.frame++,it.enabled===!0&&it.isPresenting===!0){let St=P.xr.getDepthSensingMesh();St!==null&&sd(St,N,-1/0,P.sortObjects)}sd(M,N,0,P.sortObjects),T.finish(),O!==null&&O.updateLights(R.state.lightsArray),P.sortObjects===!0&&T.sort(Yt,Ae),Un=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,Un&&L.addToRenderList(T,M),this.info.autoReset===!0&&this.info.reset(),Pe===!0&&j.beginShadows();let G=R.state.shadowsArray;if(ct.render(G,M,N),Pe===!0&&j.endShadows(),(U&&D.hasRenderPass())===!1){let St=T.opaque,ut=T.transmissive;if(R.setupLights(),N.isArrayCamera){let bt=N.cameras;if(ut.length>0)for(let Rt=0,qt=bt.length;Rt<qt;Rt++){let ne=bt[Rt];rm(St,ut,M,ne)}Un&&L.render(M);for(let Rt=0,qt=bt.length;Rt<qt;Rt++){let ne=bt[Rt];sm(T,M,ne,ne.viewport)}}else ut.length>0&&rm(St,ut,M,N),Un&&L.render(M),sm(T,M,N)}et!==null&&H===0&&($t.updateMultisampleRenderTarget(et),$t.updateRenderTargetMipmap(et)),U&&D.end(P),M.isScene===!0&&M.onAfterRender(P,M,N),lt.resetDefaultState(),$=-1,J=null,E.pop(),E.length>0?(R=E[E.length-1],$t.setTextureUnits(R.state.textureUnits),Pe===!0&&j.setGlobalState(P.clippingPlanes,R.state.camera)):R=null,y.pop(),y.length>0?T=y[y.length-1]:T=null,O!==null&&O.renderEnd()};function sd(M,N,W,U){if(M.visible===!1)return;if(M.layers.test(N.layers)){if(M.isGroup)W=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(N);else if(M.isLight)R.pushLight(M),M.castShadow&&R.pushShadow(M);else if(M.isSprite){let St=N.isArrayCamera?We:ee;if(!M.frustumCulled||M.intersectsFrustum(St)){U&&Ue.setFromMatrixPosition(M.matrixWorld).applyMatrix4(Se);let ut=nt.update(M),bt=M.material;bt.visible&&T.push(M,ut,bt,W,Ue.z,null,N)}}else if(M.isMesh||M.isLine||M.isPoints){let St=N.isArrayCamera?We:ee;if(!M.frustumCulled||M.intersectsFrustum(St)){let ut=nt.update(M),bt=M.material;if(U&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),Ue.copy(M.boundingSphere.center)):(ut.boundingSphere===null&&ut.computeBoundingSphere(),Ue.copy(ut.boundingSphere.center)),Ue.applyMatrix4(M.matrixWorld).applyMatrix4(Se)),Array.isArray(bt)){let Rt=ut.groups;for(let qt=0,ne=Rt.length;qt<ne;qt++){let Et=Rt[qt],ie=bt[Et.materialIndex];ie&&ie.visible&&T.push(M,ut,ie,W,Ue.z,Et,N)}}else bt.visible&&T.push(M,ut,bt,W,Ue.z,null,N)}}}let ft=M.children;for(let St=0,ut=ft.length;St<ut;St++)sd(ft[St],N,W,U)}function sm(M,N,W,U){let{opaque:G,transmissive:ft,transparent:St}=M;R.setupLightsView(W),Pe===!0&&j.setGlobalState(P.clippingPlanes,W),U&&mt.viewport(tt.copy(U)),G.length>0&&al(G,N,W),ft.length>0&&al(ft,N,W),St.length>0&&al(St,N,W),mt.buffers.depth.setTest(!0),mt.buffers.depth.setMask(!0),mt.buffers.color.setMask(!0),mt.setPolygonOffset(!1)}function rm(M,N,W,U){if((W.isScene===!0?W.overrideMaterial:null)!==null)return;if(R.state.transmissionRenderTarget[U.id]===void 0){let Et=we.has("EXT_color_buffer_half_float")||we.has("EXT_color_buffer_float");R.state.transmissionRenderTarget[U.id]=new In(1,1,{generateMipmaps:!0,type:Et?si:Mn,minFilter:Oi,samples:Math.max(4,Me.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:se.workingColorSpace})}let ft=R.state.transmissionRenderTarget[U.id],St=U.viewport||tt;ft.setSize(St.z*P.transmissionResolutionScale,St.w*P.transmissionResolutionScale);let ut=P.getRenderTarget(),bt=P.getActiveCubeFace(),Rt=P.getActiveMipmapLevel();P.setRenderTarget(ft),P.getClearColor(Z),yt=P.getClearAlpha(),yt<1&&P.setClearColor(16777215,.5),P.clear(),Un&&L.render(W);let qt=P.toneMapping;P.toneMapping=gi;let ne=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),R.setupLightsView(U),Pe===!0&&j.setGlobalState(P.clippingPlanes,U),al(M,W,U),$t.updateMultisampleRenderTarget(ft),$t.updateRenderTargetMipmap(ft),we.has("WEBGL_multisampled_render_to_texture")===!1){let Et=!1;for(let ie=0,Re=N.length;ie<Re;ie++){let be=N[ie],{object:ye,geometry:tn,material:At,group:un}=be;if(At.side===cn&&ye.layers.test(U.layers)){let he=At.side;At.side=gn,At.needsUpdate=!0,om(ye,W,U,tn,At,un),At.side=he,At.needsUpdate=!0,Et=!0}}Et===!0&&($t.updateMultisampleRenderTarget(ft),$t.updateRenderTargetMipmap(ft))}P.setRenderTarget(ut,bt,Rt),P.setClearColor(Z,yt),ne!==void 0&&(U.viewport=ne),P.toneMapping=qt}function al(M,N,W){let U=N.isScene===!0?N.overrideMaterial:null;for(let G=0,ft=M.length;G<ft;G++){let St=M[G],{object:ut,geometry:bt,group:Rt}=St,qt=St.material;qt.allowOverride===!0&&U!==null&&(qt=U),ut.layers.test(W.layers)&&om(ut,N,W,bt,qt,Rt)}}function om(M,N,W,U,G,ft){O!==null&&G.isNodeMaterial&&O.setObject(M,G),M.onBeforeRender(P,N,W,U,G,ft),M.modelViewMatrix.multiplyMatrices(W.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),G.onBeforeRender(P,N,W,U,M,ft),G.transparent===!0&&G.side===cn&&G.forceSinglePass===!1?(G.side=gn,G.needsUpdate=!0,P.renderBufferDirect(W,N,U,G,M,ft),G.side=us,G.needsUpdate=!0,P.renderBufferDirect(W,N,U,G,M,ft),G.side=cn):P.renderBufferDirect(W,N,U,G,M,ft),M.onAfterRender(P,N,W,U,G,ft)}function am(M){let N=0;for(let W of M)W.texture!==null&&N++;return N}function vo(M,N,W){N.isScene!==!0&&(N=Fn);let U=Ot.get(M),G=R.state.lights,ft=R.state.shadowsArray,St=G.state.version,ut=Q.getParameters(M,G.state,ft,N,W,R.state.lightProbeGridArray),bt=Q.getProgramCacheKey(ut),Rt=U.programs;U.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?N.environment:null,U.fog=N.fog;let qt=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;U.envMap=C.get(M.envMap||U.environment,qt),U.envMapRotation=U.environment!==null&&M.envMap===null?N.environmentRotation:M.envMapRotation,Rt===void 0&&(M.addEventListener("dispose",ge),Rt=new Map,U.programs=Rt,U.programVariants=new Map);let ne=Rt.get(bt);if(ne!==void 0){if(U.currentProgram===ne&&U.lightsStateVersion===St)return cm(M,ut),ne}else ut.uniforms=Q.getUniforms(M),O!==null&&M.isNodeMaterial&&O.build(M,W,ut),M.onBeforeCompile(ut,P),ne=Q.acquireProgram(ut,bt),Rt.set(bt,ne),U.uniforms=ut.uniforms;let Et=U.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(Et.clippingPlanes=j.uniform),cm(M,ut),U.needsLights=bv(M),U.lightsStateVersion=St,U.needsLights&&(Et.ambientLightColor.value=G.state.ambient,Et.lightProbe.value=G.state.probe,Et.sunLights.value=G.state.sun,Et.sunLightShadows.value=G.state.sunShadow,Et.directionalLights.value=G.state.directional,Et.directionalLightShadows.value=G.state.directionalShadow,Et.spotLights.value=G.state.spot,Et.spotLightShadows.value=G.state.spotShadow,Et.rectAreaLights.value=G.state.rectArea,Et.ltc_1.value=G.state.rectAreaLTC1,Et.ltc_2.value=G.state.rectAreaLTC2,Et.pointLights.value=G.state.point,Et.pointLightShadows.value=G.state.pointShadow,Et.hemisphereLights.value=G.state.hemi,Et.sunShadowMatrix.value=G.state.sunShadowMatrix,Et.sunShadowCascade.value=G.state.sunShadowCascade,Et.directionalShadowMatrix.value=G.state.directionalShadowMatrix,Et.spotLightMatrix.value=G.state.spotLightMatrix,Et.spotLightMap.value=G.state.spotLightMap,Et.pointShadowMatrix.value=G.state.pointShadowMatrix),U.numLightProbeGrids=am(R.state.lightProbeGridArray),U.currentProgram=ne,U.uniformsList=null,ne}function xv(M,N,W,U,G){let ft=Ot.get(M),St=ft.currentProgram.id+","+U+","+G,ut=ft.programVariants.get(St);return ut===void 0?(ut=vo(M,N,W),ft.programVariants.set(St,ut)):(ft.currentProgram=ut,ft.uniformsList=null,ft.outputColorSpace=U,ft.toneMapping=G),ut}function lm(M){if(M.uniformsList===null){let N=M.currentProgram.getUniforms();M.uniformsList=Kr.seqWithValue(N.seq,M.uniforms)}return M.uniformsList}function cm(M,N){let W=Ot.get(M);W.outputColorSpace=N.outputColorSpace,W.batching=N.batching,W.batchingColor=N.batchingColor,W.instancing=N.instancing,W.instancingColor=N.instancingColor,W.instancingMorph=N.instancingMorph,W.skinning=N.skinning,W.morphTargets=N.morphTargets,W.morphNormals=N.morphNormals,W.morphColors=N.morphColors,W.morphTargetsCount=N.morphTargetsCount,W.numClippingPlanes=N.numClippingPlanes,W.numIntersection=N.numClipIntersection,W.vertexAlphas=N.vertexAlphas,W.vertexTangents=N.vertexTangents,W.toneMapping=N.toneMapping}function yv(M,N,W,U,G){N.isScene!==!0&&(N=Fn),$t.resetTextureUnits();let ft=N.fog,St=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?N.environment:null,ut=et===null?P.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:se.workingColorSpace,bt=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,Rt=C.get(U.envMap||St,bt),qt=U.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,ne=!!W.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),Et=!!W.morphAttributes.position,ie=!!W.morphAttributes.normal,Re=!!W.morphAttributes.color,be=gi;U.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(be=P.toneMapping);let ye=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,tn=ye!==void 0?ye.length:0,At=Ot.get(U),un=R.state.lights;if(Pe===!0&&(_n===!0||M!==J)){let Te=M===J&&U.id===$;j.setState(U,M,Te)}let he=!1,Ss=!1;U.version===At.__version?At.needsLights&&At.lightsStateVersion!==un.state.version||G.isBatchedMesh&&At.batching===!1||!G.isBatchedMesh&&At.batching===!0||G.isBatchedMesh&&At.batchingColor===!0&&G._colorsTexture===null||G.isBatchedMesh&&At.batchingColor===!1&&G._colorsTexture!==null||G.isInstancedMesh&&At.instancing===!1||!G.isInstancedMesh&&At.instancing===!0||G.isSkinnedMesh&&At.skinning===!1||!G.isSkinnedMesh&&At.skinning===!0||G.isInstancedMesh&&At.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&At.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&At.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&At.instancingMorph===!1&&G.morphTexture!==null||At.envMap!==Rt||U.fog===!0&&At.fog!==ft||At.numClippingPlanes!==void 0&&(At.numClippingPlanes!==j.numPlanes||At.numIntersection!==j.numIntersection)||At.vertexAlphas!==qt||At.vertexTangents!==ne||At.morphTargets!==Et||At.morphNormals!==ie||At.morphColors!==Re||At.morphTargetsCount!==tn||At.numLightProbeGrids!==am(R.state.lightProbeGridArray)?he=!0:(At.outputColorSpace!==ut||At.toneMapping!==be)&&(Ss=!0):(he=!0,At.__version=U.version);let en=At.currentProgram;(he===!0||Ss===!0)&&(en=Ss===!0?xv(U,N,G,ut,be):vo(U,N,G),O&&U.isNodeMaterial&&O.onUpdateProgram(U,en,At));let ll=!1,Zi=!1,Ts=!1,le=en.getUniforms(),$e=At.uniforms;if(mt.useProgram(en.program)&&(ll=!0,Zi=!0,Ts=!0),U.id!==$&&($=U.id,Zi=!0),ll||J!==M){mt.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),le.setValue(F,"projectionMatrix",M.projectionMatrix),le.setValue(F,"viewMatrix",M.matrixWorldInverse);let ze=le.map.cameraPosition;ze!==void 0&&ze.setValue(F,ci.setFromMatrixPosition(M.matrixWorld)),Me.logarithmicDepthBuffer&&le.setValue(F,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&le.setValue(F,"isOrthographic",M.isOrthographicCamera===!0),J!==M&&(J=M,Zi=!0,Ts=!0)}if(At.needsLights&&(un.state.sunShadowMap.length>0&&le.setValue(F,"sunShadowMap",un.state.sunShadowMap,$t),un.state.directionalShadowMap.length>0&&le.setValue(F,"directionalShadowMap",un.state.directionalShadowMap,$t),un.state.spotShadowMap.length>0&&le.setValue(F,"spotShadowMap",un.state.spotShadowMap,$t),un.state.pointShadowMap.length>0&&le.setValue(F,"pointShadowMap",un.state.pointShadowMap,$t)),G.isSkinnedMesh){le.setOptional(F,G,"bindMatrix"),le.setOptional(F,G,"bindMatrixInverse");let Te=G.skeleton;Te&&(Te.boneTexture===null&&Te.computeBoneTexture(),le.setValue(F,"boneTexture",Te.boneTexture,$t))}G.isBatchedMesh&&(le.setOptional(F,G,"batchingTexture"),le.setValue(F,"batchingTexture",G._matricesTexture,$t),le.setOptional(F,G,"batchingIdTexture"),le.setValue(F,"batchingIdTexture",G._indirectTexture,$t),le.setOptional(F,G,"batchingColorTexture"),G._colorsTexture!==null&&le.setValue(F,"batchingColorTexture",G._colorsTexture,$t));let jn=W.morphAttributes;if((jn.position!==void 0||jn.normal!==void 0||jn.color!==void 0)&&K.update(G,W,en),(Zi||At.receiveShadow!==G.receiveShadow)&&(At.receiveShadow=G.receiveShadow,le.setValue(F,"receiveShadow",G.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&N.environment!==null&&($e.envMapIntensity.value=N.environmentIntensity),$e.dfgLUT!==void 0&&($e.dfgLUT.value=sT()),Zi){if(le.setValue(F,"toneMappingExposure",P.toneMappingExposure),At.needsLights&&vv($e,Ts),ft&&U.fog===!0&&at.refreshFogUniforms($e,ft),at.refreshMaterialUniforms($e,U,vt,kt,R.state.transmissionRenderTarget[M.id]),At.needsLights&&At.numLightProbeGrids>0){let Te=b,ze=0;for(let wi of R.state.lightProbeGridArray)wi.texture!==null&&(Te.textures[ze]=wi.texture,Te.min[ze]=wi.boundingBox.min,Te.max[ze]=wi.boundingBox.max,Te.resolution[ze]=wi.resolution,ze++);for(let wi in Te)Te[wi].length=ze;$e.probesSH.value=Te.textures,$e.probesMin.value=Te.min,$e.probesMax.value=Te.max,$e.probesResolution.value=Te.resolution}Kr.upload(F,lm(At),$e,$t)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(Kr.upload(F,lm(At),$e,$t),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&le.setValue(F,"center",G.center),le.setValue(F,"modelViewMatrix",G.modelViewMatrix),le.setValue(F,"normalMatrix",G.normalMatrix),le.setValue(F,"modelMatrix",G.matrixWorld),U.uniformsGroups!==void 0){let Te=U.uniformsGroups;for(let ze=0,wi=Te.length;ze<wi;ze++){let um=Te[ze];Pt.update(um,en),Pt.bind(um,en)}}return en}function vv(M,N){M.ambientLightColor.needsUpdate=N,M.lightProbe.needsUpdate=N,M.sunLights.needsUpdate=N,M.sunLightShadows.needsUpdate=N,M.directionalLights.needsUpdate=N,M.directionalLightShadows.needsUpdate=N,M.pointLights.needsUpdate=N,M.pointLightShadows.needsUpdate=N,M.spotLights.needsUpdate=N,M.spotLightShadows.needsUpdate=N,M.rectAreaLights.needsUpdate=N,M.hemisphereLights.needsUpdate=N}function bv(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(M,N,W){let U=Ot.get(M);U.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),Ot.get(M.texture).__webglTexture=N,Ot.get(M.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:W,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,N){let W=Ot.get(M);W.__webglFramebuffer=N,W.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(M,N=0,W=0){et=M,X=N,H=W;let U=null,G=!1,ft=!1;if(M){let ut=Ot.get(M);if(ut.__useDefaultFramebuffer!==void 0){mt.bindFramebuffer(F.FRAMEBUFFER,ut.__webglFramebuffer),tt.copy(M.viewport),wt.copy(M.scissor),Nt=M.scissorTest,mt.viewport(tt),mt.scissor(wt),mt.setScissorTest(Nt),$=-1;return}else if(ut.__webglFramebuffer===void 0)$t.setupRenderTarget(M);else if(ut.__hasExternalTextures)$t.rebindTextures(M,Ot.get(M.texture).__webglTexture,Ot.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let qt=M.depthTexture;if(ut.__boundDepthTexture!==qt){if(qt!==null&&Ot.has(qt)&&(M.width!==qt.image.width||M.height!==qt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$t.setupDepthRenderbuffer(M)}}let bt=M.texture;(bt.isData3DTexture||bt.isDataArrayTexture||bt.isCompressedArrayTexture)&&(ft=!0);let Rt=Ot.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(Rt[N])?U=Rt[N][W]:U=Rt[N],G=!0):M.samples>0&&$t.useMultisampledRTT(M)===!1?U=Ot.get(M).__webglMultisampledFramebuffer:Array.isArray(Rt)?U=Rt[W]:U=Rt,tt.copy(M.viewport),wt.copy(M.scissor),Nt=M.scissorTest}else tt.copy(Ut).multiplyScalar(vt).floor(),wt.copy(me).multiplyScalar(vt).floor(),Nt=xe;if(W!==0&&(U=B),mt.bindFramebuffer(F.FRAMEBUFFER,U)&&mt.drawBuffers(M,U),mt.viewport(tt),mt.scissor(wt),mt.setScissorTest(Nt),G){let ut=Ot.get(M.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+N,ut.__webglTexture,W)}else if(ft){let ut=N;for(let bt=0;bt<M.textures.length;bt++){let Rt=Ot.get(M.textures[bt]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+bt,Rt.__webglTexture,W,ut)}}else if(M!==null&&W!==0){let ut=Ot.get(M.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ut.__webglTexture,W)}$=-1};function hm(M){let N=Ot.get(M);return(N.__readFormat!==M.format||N.__readType!==M.type)&&(N.__readFormat=M.format,N.__readType=M.type,N.__formatReadable=Me.textureFormatReadable(M.format),N.__typeReadable=Me.textureTypeReadable(M.type)),N}this.readRenderTargetPixels=function(M,N,W,U,G,ft,St,ut=0){if(!(M&&M.isWebGLRenderTarget)){Bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let bt=Ot.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&St!==void 0&&(bt=bt[St],Array.isArray(bt)&&(bt=bt[0])),bt){mt.bindFramebuffer(F.FRAMEBUFFER,bt);try{let Rt=M.textures[ut],qt=Rt.format,ne=Rt.type;M.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ut);let Et=hm(Rt);if(Et.__formatReadable===!1){Bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Et.__typeReadable===!1){Bt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=M.width-U&&W>=0&&W<=M.height-G&&F.readPixels(N,W,U,G,rt.convert(qt),rt.convert(ne),ft)}finally{let Rt=et!==null?Ot.get(et).__webglFramebuffer:null;mt.bindFramebuffer(F.FRAMEBUFFER,Rt)}}},this.readRenderTargetPixelsAsync=async function(M,N,W,U,G,ft,St,ut=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let bt=Ot.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&St!==void 0&&(bt=bt[St],Array.isArray(bt)&&(bt=bt[0])),bt)if(N>=0&&N<=M.width-U&&W>=0&&W<=M.height-G){mt.bindFramebuffer(F.FRAMEBUFFER,bt);let Rt=M.textures[ut],qt=Rt.format,ne=Rt.type;M.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ut);let Et=hm(Rt);if(Et.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Et.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ie=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,ie),F.bufferData(F.PIXEL_PACK_BUFFER,ft.byteLength,F.STREAM_READ),F.readPixels(N,W,U,G,rt.convert(qt),rt.convert(ne),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Re=et!==null?Ot.get(et).__webglFramebuffer:null;mt.bindFramebuffer(F.FRAMEBUFFER,Re);let be=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await $g(F,be,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,ie),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,ft),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(ie),F.deleteSync(be),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,N=null,W=0){let U=Math.pow(2,-W),G=Math.floor(M.image.width*U),ft=Math.floor(M.image.height*U),St=N!==null?N.x:0,ut=N!==null?N.y:0;$t.setTexture2D(M,0),F.copyTexSubImage2D(F.TEXTURE_2D,W,0,0,St,ut,G,ft),mt.unbindTexture()},this.copyTextureToTexture=function(M,N,W=null,U=null,G=0,ft=0){let St,ut,bt,Rt,qt,ne,Et,ie,Re,be=M.isCompressedTexture?M.mipmaps[ft]:M.image;if(W!==null)St=W.max.x-W.min.x,ut=W.max.y-W.min.y,bt=W.isBox3?W.max.z-W.min.z:1,Rt=W.min.x,qt=W.min.y,ne=W.isBox3?W.min.z:0;else{let le=Math.pow(2,-G);St=Math.floor(be.width*le),ut=Math.floor(be.height*le),M.isDataArrayTexture?bt=be.depth:M.isData3DTexture?bt=Math.floor(be.depth*le):bt=1,Rt=0,qt=0,ne=0}U!==null?(Et=U.x,ie=U.y,Re=U.z):(Et=0,ie=0,Re=0);let ye=rt.convert(N.format),tn=rt.convert(N.type),At;N.isData3DTexture?($t.setTexture3D(N,0),At=F.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?($t.setTexture2DArray(N,0),At=F.TEXTURE_2D_ARRAY):($t.setTexture2D(N,0),At=F.TEXTURE_2D),mt.activeTexture(F.TEXTURE0),mt.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,N.flipY),mt.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),mt.pixelStorei(F.UNPACK_ALIGNMENT,N.unpackAlignment);let un=mt.getParameter(F.UNPACK_ROW_LENGTH),he=mt.getParameter(F.UNPACK_IMAGE_HEIGHT),Ss=mt.getParameter(F.UNPACK_SKIP_PIXELS),en=mt.getParameter(F.UNPACK_SKIP_ROWS),ll=mt.getParameter(F.UNPACK_SKIP_IMAGES);mt.pixelStorei(F.UNPACK_ROW_LENGTH,be.width),mt.pixelStorei(F.UNPACK_IMAGE_HEIGHT,be.height),mt.pixelStorei(F.UNPACK_SKIP_PIXELS,Rt),mt.pixelStorei(F.UNPACK_SKIP_ROWS,qt),mt.pixelStorei(F.UNPACK_SKIP_IMAGES,ne);let Zi=M.isDataArrayTexture||M.isData3DTexture,Ts=N.isDataArrayTexture||N.isData3DTexture;if(M.isDepthTexture){let le=Ot.get(M),$e=Ot.get(N),jn=Ot.get(le.__renderTarget),Te=Ot.get($e.__renderTarget);mt.bindFramebuffer(F.READ_FRAMEBUFFER,jn.__webglFramebuffer),mt.bindFramebuffer(F.DRAW_FRAMEBUFFER,Te.__webglFramebuffer);for(let ze=0;ze<bt;ze++)Zi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ot.get(M).__webglTexture,G,ne+ze),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ot.get(N).__webglTexture,ft,Re+ze)),F.blitFramebuffer(Rt,qt,Rt+St,qt+ut,Et,ie,Et+St,ie+ut,F.DEPTH_BUFFER_BIT,F.NEAREST);mt.bindFramebuffer(F.READ_FRAMEBUFFER,null),mt.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(G!==0||M.isRenderTargetTexture||Ot.has(M)){let le=Ot.get(M),$e=Ot.get(N);mt.bindFramebuffer(F.READ_FRAMEBUFFER,I),mt.bindFramebuffer(F.DRAW_FRAMEBUFFER,V);for(let jn=0;jn<bt;jn++)Zi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,le.__webglTexture,G,ne+jn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,le.__webglTexture,G),Ts?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,$e.__webglTexture,ft,Re+jn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,$e.__webglTexture,ft),G!==0?F.blitFramebuffer(Rt,qt,Rt+St,qt+ut,Et,ie,Et+St,ie+ut,F.COLOR_BUFFER_BIT,F.NEAREST):Ts?F.copyTexSubImage3D(At,ft,Et,ie,Re+jn,Rt,qt,St,ut):F.copyTexSubImage2D(At,ft,Et,ie,Rt,qt,St,ut);mt.bindFramebuffer(F.READ_FRAMEBUFFER,null),mt.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Ts?M.isDataTexture||M.isData3DTexture?F.texSubImage3D(At,ft,Et,ie,Re,St,ut,bt,ye,tn,be.data):N.isCompressedArrayTexture?F.compressedTexSubImage3D(At,ft,Et,ie,Re,St,ut,bt,ye,be.data):F.texSubImage3D(At,ft,Et,ie,Re,St,ut,bt,ye,tn,be):M.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,ft,Et,ie,St,ut,ye,tn,be.data):M.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,ft,Et,ie,be.width,be.height,ye,be.data):F.texSubImage2D(F.TEXTURE_2D,ft,Et,ie,St,ut,ye,tn,be);mt.pixelStorei(F.UNPACK_ROW_LENGTH,un),mt.pixelStorei(F.UNPACK_IMAGE_HEIGHT,he),mt.pixelStorei(F.UNPACK_SKIP_PIXELS,Ss),mt.pixelStorei(F.UNPACK_SKIP_ROWS,en),mt.pixelStorei(F.UNPACK_SKIP_IMAGES,ll),ft===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&F.generateMipmap(At),mt.unbindTexture()},this.initRenderTarget=function(M){Ot.get(M).__webglFramebuffer===void 0&&$t.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?$t.setTextureCube(M,0):M.isData3DTexture?$t.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?$t.setTexture2DArray(M,0):$t.setTexture2D(M,0),mt.unbindTexture()},this.resetState=function(){X=0,H=0,et=null,mt.reset(),lt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Hn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=se._getDrawingBufferColorSpace(t),e.unpackColorSpace=se._getUnpackColorSpace()}};var D0="wisch-theme",N0=()=>document.documentElement,Of=new Set,Dh=!1,Ff=null,rT=()=>{try{let i=localStorage.getItem(D0);return i==="light"||i==="dark"?i:null}catch{return null}};function fs(){return Dh?"light":Ff??(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function k0(i){Ff=i;try{localStorage.setItem(D0,i)}catch{}Ih()}function ps(i){return Of.add(i),()=>Of.delete(i)}function Ih(){N0().dataset.theme=fs(),Lh=null;for(let i of Of)i()}function O0(){Ff=rT(),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",Ih);let i=t=>{Dh!==t&&(Dh=t,Ih())};matchMedia("print").addEventListener("change",({matches:t})=>i(t)),addEventListener("beforeprint",()=>i(!0)),addEventListener("afterprint",()=>i(!1)),Ih()}var Qr=()=>Dh,Lh=null;function gt(i){Lh??=new Map;let t=Lh.get(i);return t===void 0&&(t=getComputedStyle(N0()).getPropertyValue(`--${i}`).trim()||"#888888",Lh.set(i,t)),t}function B0(i,t=!1){let e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new Ft;l.morphTargetsRelative=a;let c=0;for(let h=0;h<i.length;++h){let u=i[h],d=0,f=0;if(e!==(u.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in u.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(u.attributes[p]),d++}if(d!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==u.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in u.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(u.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(u.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=u.index.count;else if(u.attributes.position!==void 0)p=u.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,h),c+=p}}if(e){let h=0,u=[];for(let d=0;d<i.length;++d){let f=i[d].index;for(let p=0;p<f.count;++p)u.push(f.getX(p)+h);h+=i[d].attributes.position.count}l.setIndex(u)}for(let h in r){let u=F0(r[h]);if(!u)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,u)}for(let h in o){let u=o[h][0].length;if(u!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let d=0;d<u;++d){let f=[];for(let x=0;x<o[h].length;++x)f.push(o[h][x][d]);let p=F0(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(p)}}}return l}function F0(i){let t,e,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new re(o,e,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let u=l/e;for(let d=0,f=h.count;d<f;d++)for(let p=0;p<e;p++){let x=h.getComponent(d,p);a.setComponent(d+u,p,x)}}else o.set(h.array,l);l+=h.count*e}return s!==void 0&&(a.gpuType=s),a}function z0(i,t=1e-4){t=Math.max(t,Number.EPSILON);let e={},n=i.getIndex(),s=i.getAttribute("position"),r=n?n.count:s.count,o=0,a=Object.keys(i.attributes),l=[],c=new Map,h=[],u=["getX","getY","getZ","getW"],d=t*.5,f=Math.log10(1/t),p=Math.pow(10,f),x=d*p;for(let g=0;g<r;g++){let v=n?n.getX(g):g,S="";for(let b=0,T=a.length;b<T;b++){let R=a[b],y=i.getAttribute(R),E=y.itemSize;for(let D=0;D<E;D++)S+=`${Math.trunc(y[u[D]](v)*p+x)},`}S in e?h.push(e[S]):(l.push(v),e[S]=o,h.push(o),o++)}let m=i.clone();for(let g in i.attributes)m.setAttribute(g,U0(i.attributes[g],l,c));for(let g in i.morphAttributes)m.morphAttributes[g]=i.morphAttributes[g].map(v=>U0(v,l,c));return m.setIndex(h),m}function G0(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let b=0;b<s;b++)r[3*b+0]=n.getX(b),r[3*b+1]=n.getY(b),r[3*b+2]=n.getZ(b)}let o=Math.cos(t),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let b=0;b<l;b++){let T=9*b,R=r[T+0],y=r[T+1],E=r[T+2],D=r[T+3],P=r[T+4],k=r[T+5],O=r[T+6],B=r[T+7],I=r[T+8],V=O-D,X=B-P,H=I-k,et=R-D,$=y-P,J=E-k,tt=X*J-H*$,wt=H*et-V*J,Nt=V*$-X*et,Z=1/(Math.sqrt(tt*tt+wt*wt+Nt*Nt)||1);c[3*b+0]=tt*Z,c[3*b+1]=wt*Z,c[3*b+2]=Nt*Z}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,p=new Int32Array(d),x=0;for(let b=0;b<s;b++){let T=3*b,R=Math.trunc(r[T+0]*a),y=Math.trunc(r[T+1]*a),E=Math.trunc(r[T+2]*a),D=(Math.imul(R,73856093)^Math.imul(y,19349663)^Math.imul(E,83492791))&f;for(;;){let P=p[D];if(P===0){let O=3*x;u[O+0]=R,u[O+1]=y,u[O+2]=E,p[D]=x+1,h[b]=x++;break}let k=3*(P-1);if(u[k+0]===R&&u[k+1]===y&&u[k+2]===E){h[b]=P-1;break}D=D+1&f}}let m=new Int32Array(x+1);for(let b=0;b<s;b++)m[h[b]+1]++;for(let b=0;b<x;b++)m[b+1]+=m[b];let g=new Int32Array(s),v=m.slice(0,x);for(let b=0;b<l;b++){let T=3*b;g[v[h[T+0]]++]=b,g[v[h[T+1]]++]=b,g[v[h[T+2]]++]=b}let S=new Float32Array(s*3);for(let b=0;b<l;b++){let T=3*b,R=c[T+0],y=c[T+1],E=c[T+2];for(let D=0;D<3;D++){let P=T+D,k=h[P],O=0,B=0,I=0;for(let X=m[k],H=m[k+1];X<H;X++){let et=3*g[X],$=c[et+0],J=c[et+1],tt=c[et+2];R*$+y*J+E*tt>o&&(O+=$,B+=J,I+=tt)}let V=1/(Math.sqrt(O*O+B*B+I*I)||1);S[3*P+0]=O*V,S[3*P+1]=B*V,S[3*P+2]=I*V}}return e.setAttribute("normal",new re(S,3,!1)),e}function U0(i,t,e=new Map){let n=i.isInterleavedBufferAttribute,s=n?i.data:i,r=n?s.stride:i.itemSize,o=n?e.get(s):void 0;if(o===void 0){let l=new s.array.constructor(t.length*r);for(let c=0;c<t.length;c++)for(let h=0;h<r;h++)l[c*r+h]=s.array[t[c]*r+h];o=n?new s.constructor(l,r,s.meshPerAttribute):new i.constructor(l,i.itemSize,i.normalized,i.meshPerAttribute),o.setUsage(s.usage),n&&e.set(s,o)}let a=n?new i.constructor(o,i.itemSize,i.offset,i.normalized):o;return a.name=i.name,n||(a.gpuType=i.gpuType),a}var oT=new A(1,1,1),aT=.7;function ce([i,t,e,n,s,r,o],a=new Lt){return a.compose(new A(i,t,e),new Le(n,s,r,o).normalize(),oT)}function yn(i,t){return i.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      gl_Position.z = (projectionMatrix * vec4(${t.toFixed(3)} * mvPosition.xyz, 1.0)).z / ${t.toFixed(3)};`)},i.customProgramCacheKey=()=>`shifted ${t}`,i}var V0=new WeakMap;function lT(i){if(!i)return new Ft;let t=V0.get(i);if(!t){let e=new Ft;e.setAttribute("position",new re(Float32Array.from(i.vertices,n=>n/er),3)),e.setIndex(i.triangles),t=G0(e,aT),V0.set(i,t)}return t}function zi(i,t){switch(i.kind){case"box":return new Ln(...i.size);case"sphere":return new ki(i.radius,28,18);case"cylinder":return new rs(i.radius,i.radius,i.length,32).rotateX(Math.PI/2);case"capsule":return new Is(i.radius,i.length,10,28).rotateX(Math.PI/2);case"mesh":return lT(t[i.mesh]);default:return new Ft}}var H0=new WeakMap;function Fa(i){let t=H0.get(i);if(t)return t;let[e,n]=[Math.cos(i.axis_rad),Math.sin(i.axis_rad)],[s,r]=[Math.cos(i.half_angle_rad),Math.sin(i.half_angle_rad)*Math.sign(i.radius_m)],o={along:[e,n],cosine:s,sine:r,slant:i.radius_m/r,axis:new A(s*e,s*n,-r),radial:new A(r*e,r*n,s),across:new A(-n,e,0)};return H0.set(i,o),o}function cT(i,t,e){let{along:n,slant:s}=Fa(i);return Math.atan2(n[0]*e-n[1]*t,s+n[0]*t+n[1]*e)}function W0(i,t,e){return cT(i,t,e)/Fa(i).sine}function $0(i,t,e,n){let{along:s,slant:r,sine:o,cosine:a,axis:l,radial:c,across:h}=Fa(i),[u,d]=[s[0]*t+s[1]*e,s[0]*e-s[1]*t],f=(u*(2*r+u)+d*d)/(Math.hypot(r+u,d)+r),p=Math.atan2(d,r+u)/o,x=h.clone().multiplyScalar(Math.sin(p)).addScaledVector(c,-2*Math.sin(p/2)**2),m=x.clone().add(c);return x.multiplyScalar(i.radius_m).addScaledVector(l,a*f).addScaledVector(m,o*f).addScaledVector(m,a*n).addScaledVector(l,-o*n).toArray()}function X0(i,t){let{sine:e,cosine:n,axis:s,radial:r,across:o}=Fa(i),[a,l]=[r.dot(t)+i.radius_m,o.dot(t)];return r.clone().multiplyScalar(a).addScaledVector(o,l).multiplyScalar(Math.sign(i.radius_m)).normalize().multiplyScalar(n).addScaledVector(s,-e)}function q0(i,t){let{along:e,slant:n,sine:s}=Fa(i),[r,o]=[Math.sin(t*s),Math.cos(t*s)];return(a,l)=>Math.sign(s)*(o*(e[0]*l-e[1]*a)-r*(n+e[0]*a+e[1]*l))}var Uf=class{constructor(t){this.shape=t;let{points:e,places:n,triangles:s}=t;this.geometry=new Ft,this.geometry.setAttribute("position",new re(Float32Array.from(e),3)),this.geometry.setIndex([...s]),this.geometry.computeVertexNormals(),this.normals=this.geometry.getAttribute("normal").array;let r=[-1/0,-1/0];for(let a=0;a<n.length;a++)this.low[a%2]=Math.min(this.low[a%2],n[a]),r[a%2]=Math.max(r[a%2],n[a]);let o=[r[0]-this.low[0],r[1]-this.low[1]];this.cell=Math.max(Math.sqrt(3*o[0]*o[1]/Math.max(s.length,1)),1e-4),this.columns=Math.floor(o[0]/this.cell)+1;for(let a=0;a<s.length;a+=3){let l=[0,1,2].map(u=>s[a+u]);l.forEach(u=>this.triangleOf[u]??=a);let[c,h]=[0,1].map(u=>{let d=l.map(f=>Math.floor((n[2*f+u]-this.low[u])/this.cell));return[Math.min(...d),Math.max(...d)]});for(let u=h[0];u<=h[1];u++)for(let d=c[0];d<=c[1];d++)(this.cells[u*this.columns+d]??=[]).push(a)}}shape;geometry;normals;low=[1/0,1/0];cell;columns;cells=[];triangleOf=[];lift(t,e,n){let s=this.find(t,e),r=this.mean(this.shape.points,s),o=this.mean(this.normals,s).normalize();return r.addScaledVector(o,n).toArray()}normalNear(t){let{points:e}=this.shape,[n,s]=[0,1/0];for(let r=0;r<e.length;r+=3){let o=(e[r]-t.x)**2+(e[r+1]-t.y)**2+(e[r+2]-t.z)**2;o<s&&([n,s]=[r,o])}return new A().fromArray(this.normals,n)}mean(t,{corners:e,weights:n}){let s=new A;return e.forEach((r,o)=>{s.x+=n[o]*t[3*r],s.y+=n[o]*t[3*r+1],s.z+=n[o]*t[3*r+2]}),s}find(t,e){let[n,s]=[Math.floor((t-this.low[0])/this.cell),Math.floor((e-this.low[1])/this.cell)],r=n>=0&&n<this.columns&&s>=0?this.cells[s*this.columns+n]??[]:[];for(let c of r){let h=this.locate(c,t,e);if(h.weights.every(u=>u>=-1e-6))return h}let{places:o}=this.shape,[a,l]=[0,1/0];for(let c=0;c<this.triangleOf.length;c++){let h=(o[2*c]-t)**2+(o[2*c+1]-e)**2;h<l&&([a,l]=[c,h])}return this.locate(this.triangleOf[a]??0,t,e)}locate(t,e,n){let{places:s,triangles:r}=this.shape,o=[r[t],r[t+1],r[t+2]],[a,l,c]=[2*o[0],2*o[1],2*o[2]],[h,u,d,f,p,x]=[s[a],s[a+1],s[l],s[l+1],s[c],s[c+1]],m=(d-h)*(x-u)-(f-u)*(p-h),g=((e-h)*(x-u)-(n-u)*(p-h))/m,v=((d-h)*(n-u)-(f-u)*(e-h))/m;return{corners:o,weights:[1-g-v,g,v]}}},Y0=new WeakMap;function Ua(i){let t=Y0.get(i);if(t)return t;let e=new Uf(i);return Y0.set(i,e),e}var j0=.05,K0=.02,J0=500,hT=64;function zf({axis_rad:i}){let[t,e]=[Math.cos(i),Math.sin(i)];return[[t,e],[-e,t]]}function Nh(i,t,e){if(i.kind==="cone")return W0(i,t,e);let[,n]=zf(i);return(n[0]*t+n[1]*e)/i.radius_m}function uT(i,t,e){let n=i.kind==="mesh"?Math.hypot(e[0]-t[0],e[1]-t[1])/K0:Math.abs(Nh(i,e[0],e[1])-Nh(i,t[0],t[1]))/j0;return Math.min(J0,Math.max(1,Math.ceil(n)))}function oi(i,t,e,n){if(!i)return[t,e,n];if(i.kind==="mesh")return Ua(i).lift(t,e,n);if(i.kind==="cone")return $0(i,t,e,n);let[s,r]=zf(i),o=s[0]*t+s[1]*e,a=(r[0]*t+r[1]*e)/i.radius_m,l=(i.radius_m+n)*Math.sin(a);return[s[0]*o+r[0]*l,s[1]*o+r[1]*l,n*Math.cos(a)-2*i.radius_m*Math.sin(a/2)**2]}function ms({pose:i,shape:t},e){let n=ce(i),s=new A(0,0,1),r=e.clone().applyMatrix4(n.clone().invert());if(t?.kind==="mesh")s.copy(Ua(t).normalNear(r));else if(t?.kind==="cone")s.copy(X0(t,r));else if(t){let[,o]=zf(t),[a,l]=[o[0]*r.x+o[1]*r.y,r.z+t.radius_m];s.set(o[0]*a,o[1]*a,l).multiplyScalar(Math.sign(t.radius_m)).normalize()}return s.transformDirection(n)}function gs(i,t,e){if(!i)return[...t];let n=[];for(let s=0;s<t.length;s++){let[r,o,a]=t[s],l=s+1<t.length?t[s+1]:e?t[0]:null,c=l?uT(i,t[s],l):1;for(let h=0;h<c;h++){let u=h/c,d=l??t[s];n.push(oi(i,r+u*(d[0]-r),o+u*(d[1]-o),a+u*(d[2]-a)))}}return n}function Z0(i,t){let e=[];return i.forEach((n,s)=>{let r=i[(s+1)%i.length],[o,a]=[t(n),t(r)];if(o>=0&&e.push(n),o>=0!=a>=0){let l=o/(o-a);e.push([n[0]+l*(r[0]-n[0]),n[1]+l*(r[1]-n[1]),n[2]+l*(r[2]-n[2])])}}),e}function dT(i){let t=e=>{if(i.kind==="cylinder")return([s,r])=>Nh(i,s,r)-e;let n=q0(i,e);return([s,r])=>n(s,r)};return(e,n)=>{let s=e.map(([c,h])=>Nh(i,c,h)),[r,o]=[Math.min(...s),Math.max(...s)],a=Math.max(j0,(o-r)/J0),l=Math.floor(r/a);for(let c=l;c<Math.max(o/a,l+.5);c++){let[h,u]=[t(c*a),t((c+1)*a)],d=Z0(Z0(e,h),f=>-u(f));for(let f=1;f+1<d.length;f++)n([d[0],d[f],d[f+1]])}}}function Bf([i,t,e],n,s=0){let r=[[i,t],[t,e],[e,i]].map(([d,f])=>Math.hypot(d[0]-f[0],d[1]-f[1])),o=r.indexOf(Math.max(...r)),a=s||Math.max(K0,r[o]/hT);if(r[o]<=a)return n([i,t,e]);let[l,c,h]=[[i,t,e],[t,e,i],[e,i,t]][o],u=[(l[0]+c[0])/2,(l[1]+c[1])/2,(l[2]+c[2])/2];Bf([l,u,h],n,a),Bf([u,c,h],n,a)}function Gf(i,t){if(!i)return t;let e=t.index?t.toNonIndexed():t,{array:n,count:s}=e.getAttribute("position"),r=[],o=i.kind==="mesh"?Bf:dT(i),a=c=>{for(let[h,u,d]of c)r.push(...oi(i,h,u,d))};for(let c=0;c+2<s;c+=3){let h=u=>[n[3*(c+u)],n[3*(c+u)+1],n[3*(c+u)+2]];o([h(0),h(1),h(2)],a)}let l=new Ft;return l.setAttribute("position",new re(Float32Array.from(r),3)),l.computeVertexNormals(),t.dispose(),l}pt.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new st},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};xn.line={uniforms:La.merge([pt.common,pt.fog,pt.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var He=class extends $n{constructor(t){super({type:"LineMaterial",uniforms:La.clone(xn.line.uniforms),vertexShader:xn.line.vertexShader,fragmentShader:xn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Q0=new Ne,kh=new A,Hs=class extends ba{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Vt(t,3)),this.setAttribute("uv",new Vt(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new mi(e,6,1);return this.setAttribute("instanceStart",new Ye(n,3,0)),this.setAttribute("instanceEnd",new Ye(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new mi(e,6,1);return this.setAttribute("instanceColorStart",new Ye(n,3,0)),this.setAttribute("instanceColorEnd",new Ye(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new ha(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ne);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),Q0.setFromBufferAttribute(e),this.boundingBox.union(Q0))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new an),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)kh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(kh)),kh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(kh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Vf=new pe,tx=new A,ex=new A,Ze=new pe,je=new pe,yi=new pe,Hf=new A,Wf=new Lt,Ke=new _a,nx=new A,Oh=new Ne,Fh=new an,vi=new pe,bi,Ws;function ix(i,t,e){return vi.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),vi.multiplyScalar(1/vi.w),vi.x=Ws/e.width,vi.y=Ws/e.height,vi.applyMatrix4(i.projectionMatrixInverse),vi.multiplyScalar(1/vi.w),Math.abs(Math.max(vi.x,vi.y))}function fT(i,t){let e=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Ke.start.fromBufferAttribute(s,a),Ke.end.fromBufferAttribute(r,a),Ke.applyMatrix4(e);let c=new A,h=new A;bi.distanceSqToSegment(Ke.start,Ke.end,h,c),h.distanceTo(c)<Ws*.5&&t.push({point:h,pointOnLine:c,distance:bi.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function pT(i,t,e){let n=t.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),u=-t.near;bi.at(1,yi),yi.w=1,yi.applyMatrix4(t.matrixWorldInverse),yi.applyMatrix4(n),yi.multiplyScalar(1/yi.w),yi.x*=r.x/2,yi.y*=r.y/2,yi.z=0,Hf.copy(yi),Wf.multiplyMatrices(t.matrixWorldInverse,o);for(let d=0,f=h;d<f;d++){if(Ze.fromBufferAttribute(l,d),je.fromBufferAttribute(c,d),Ze.w=1,je.w=1,Ze.applyMatrix4(Wf),je.applyMatrix4(Wf),Ze.z>u&&je.z>u)continue;if(Ze.z>u){let S=Ze.z-je.z,b=(Ze.z-u)/S;Ze.lerp(je,b)}else if(je.z>u){let S=je.z-Ze.z,b=(je.z-u)/S;je.lerp(Ze,b)}Ze.applyMatrix4(n),je.applyMatrix4(n),Ze.multiplyScalar(1/Ze.w),je.multiplyScalar(1/je.w),Ze.x*=r.x/2,Ze.y*=r.y/2,je.x*=r.x/2,je.y*=r.y/2,Ke.start.copy(Ze),Ke.start.z=0,Ke.end.copy(je),Ke.end.z=0;let x=Ke.closestPointToPointParameter(Hf,!0);Ke.at(x,nx);let m=jr.lerp(Ze.z,je.z,x),g=m>=-1&&m<=1,v=Hf.distanceTo(nx)<Ws*.5;if(g&&v){Ke.start.fromBufferAttribute(l,d),Ke.end.fromBufferAttribute(c,d),Ke.start.applyMatrix4(o),Ke.end.applyMatrix4(o);let S=new A,b=new A;bi.distanceSqToSegment(Ke.start,Ke.end,b,S),e.push({point:b,pointOnLine:S,distance:bi.origin.distanceTo(b),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var Ba=class extends ae{constructor(t=new Hs,e=new He({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)tx.fromBufferAttribute(e,o),ex.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+tx.distanceTo(ex);let r=new mi(s,2,1);return t.setAttribute("instanceDistanceStart",new Ye(r,1,0)),t.setAttribute("instanceDistanceEnd",new Ye(r,1,1)),this}raycast(t,e){let n=this.material.worldUnits,s=t.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;bi=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Ws=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Fh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Ws*.5;else{let u=Math.max(s.near,Fh.distanceToPoint(bi.origin));c=ix(s,u,l.resolution)}if(Fh.radius+=c,bi.intersectsSphere(Fh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Oh.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=Ws*.5;else{let u=Math.max(s.near,Oh.distanceToPoint(bi.origin));h=ix(s,u,l.resolution)}Oh.expandByScalar(h),bi.intersectsBox(Oh)!==!1&&(n?fT(this,e):pT(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(Vf),this.material.uniforms.resolution.value.set(Vf.z,Vf.w))}};var mT={polygonOffset:!0,polygonOffsetFactor:-4,polygonOffsetUnits:-4};function qn(i,t){let e=new Hs;e.setPositions(i.length?Float32Array.from(i):new Float32Array(6));let n=new Ba(e,t);return n.frustumCulled=!1,n.visible=i.length>0,n}function xs(i,t){let e=[];for(let n=0;n+(t?0:1)<i.length;n++)e.push(...i[n],...i[(n+1)%i.length]);return e}var gT=2e3;function Uh(i,t){let e=[],n=0,s=c=>Math.hypot(i[c+3]-i[c],i[c+4]-i[c+1],i[c+5]-i[c+2]),r=0;for(let c=0;c+5<i.length;c+=6)r+=s(c);let o=Math.max(1,r/(gT*(t[0]+t[1]))),[a,l]=[o*t[0],o*t[1]];for(let c=0;c+5<i.length;c+=6){let h=d=>[0,1,2].map(f=>i[c+f]+d*(i[c+3+f]-i[c+f])),u=s(c);for(let d=-(n%(a+l));d<u;d+=a+l){let[f,p]=[Math.max(0,d),Math.min(u,d+a)];p>f&&e.push(...h(f/u),...h(p/u))}n+=u}return e}var to=class{constructor(t,e){this.palette=e;let n=new He({linewidth:t,vertexColors:!0,...mT});this.line=new Ba(new Hs,n),this.line.frustumCulled=!1,this.line.visible=!1}palette;line;positions=new nn;kinds=new nn;changed=!0;get count(){return this.kinds.length}clear(){this.positions.length=this.kinds.length=0,this.changed=!0}push(t,e){for(let n of t)this.positions.push(n);this.kinds.push(e),this.changed=!0}end(t){return new A().fromArray(this.positions.data,6*t+3)}paint(t){this.palette=t,this.changed=!0}show(t){this.changed&&this.upload(),this.line.geometry.instanceCount=Math.min(t,this.count),this.line.visible=t>0}dispose(){this.line.geometry.dispose(),this.line.material.dispose()}upload(){this.changed=!1;let{geometry:t}=this.line;t.dispose();let e=6*Math.max(1,this.count),n=new Float32Array(e);for(let s=0;s<this.count;s++){let{r,g:o,b:a}=this.palette[this.kinds.data[s]];n.set([r,o,a,r,o,a],6*s)}for(let[s,r]of[["",Float32Array.from(this.positions.data.subarray(0,e))],["Color",n]]){let o=new mi(r,6,1);t.setAttribute(`instance${s}Start`,new Ye(o,3,0)),t.setAttribute(`instance${s}End`,new Ye(o,3,3))}}};var xT={axis:"",rounds:"Round",phases:"Phase, stroke",contact:"Contact",events:"Events",force:"Force [N]",height:"Height [mm]",performance:`Performance
[%]`},yT={axis:20,rounds:20,phases:18,contact:12,events:18,force:74,height:50,performance:88},za=[3,2],sx=[1,4],$f=new Set(["force","height","performance"]),vT=4,Bh=class{constructor(t){this.names=t}names;lanes=[];left=112;right=22;width=600;height=0;from=0;to=1;layOut(t,e){this.width=t;let n=t<560;this.left=n?34:112;let s=0;this.lanes=this.names.map(r=>{let o=$f.has(r);n&&o&&(s+=13);let a={name:r,label:xT[r],top:s,height:Math.round(yT[r]*(o&&e?.66:1))};return s+=a.height+vT+(o?4:0),a}),this.height=s}get narrow(){return this.left<100}get span(){return this.width-this.left-this.right}x(t){return this.left+(t-this.from)/(this.to-this.from)*this.span}t(t){return this.from+(t-this.left)/this.span*(this.to-this.from)}lane(t){return this.lanes.find(e=>e.name===t)}},bT=[.01,.02,.05,.1,.2,.5,1,2,5,10,20,30,60,120,300,600,1200,1800,3600,7200];function zh(i,t,e){let n=bT.find(r=>(t-i)/r<=e)??(t-i)/e,s=[];for(let r=Math.ceil(i/n-1e-9);r*n<=t+1e-9;r++)s.push(r*n);return{step:n,times:s}}function rx(i,t,e){let n=(t-i)/e,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=n*.999)??n,o=[];for(let a=Math.ceil(i/r-1e-9);a*r<=t+1e-9*r;a++)o.push(a*r);return o}var ai=(i,t=11,e=400)=>{i.font=`${e} ${t}px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif`};function $s(i,t,e,n,s){if(s<14)return;let r=t.length>200?t.slice(0,200):t;if(i.measureText(r).width>s){for(;r.length>1&&i.measureText(`${r}\u2026`).width>s;)r=r.slice(0,-1);if(r.length<3)return;r+="\u2026"}i.fillText(r,e,n)}function Je(i,t,e,n,s,r,o=1){i.strokeStyle=gt(r),i.lineWidth=o,i.beginPath(),i.moveTo(t,e),i.lineTo(n,s),i.stroke()}var _T=1.12,wT=1.8,ox=16,MT=[.45,.7,.95];function Xf(i,t){for(let e of i)if(e.visible){if(e instanceof ae){let n=e.geometry;n.boundingBox||n.computeBoundingBox(),n.boundingBox.isEmpty()||t(e,n.boundingBox)}Xf(e.children,t)}}function Xs(i){let t=[];return Xf(i,({matrixWorld:e},{min:n,max:s})=>{for(let r=0;r<8;r++)t.push(new A(r&1?s.x:n.x,r&2?s.y:n.y,r&4?s.z:n.z).applyMatrix4(e))}),t}function Gh(i){let t=[];return Xf(i,({matrixWorld:e},n)=>t.push({blockFromWorld:e.clone().invert(),box:n})),t}function qf({blockFromWorld:i,box:t},e,n){let s=e.clone().applyMatrix4(i),r=n.clone().applyMatrix4(i).sub(s),o=new pi(s,r.clone().normalize()).intersectBox(t,new A);return t.containsPoint(s)||o!==null&&o.distanceTo(s)<r.length()}function ax(i,t,e){return i.length?i.filter(n=>{let s=n.clone().addScaledVector(t,wT);return!e.some(r=>qf(r,n,s))}).length/i.length:1}function lx(i,t,e,n){let[s,r]=[n,-1/0];for(let o of MT)for(let a=0;a<ox;a++){let l=2*Math.PI*a/ox,c=new A(Math.cos(o)*Math.cos(l),Math.cos(o)*Math.sin(l),Math.sin(o)),h=c.dot(e);if(h<.2)continue;let u=0;for(let{blocks:f,tool:p}of i)u+=(3*ax(p,c,f)+2*ax(t,c,f))/i.length;let d=u+2*Math.min(h,.8)+.6*c.dot(n);d>r&&([s,r]=[c,d])}return s}var Vh=i=>i.reduce((t,e)=>t.addScaledVector(e,1/i.length),new A);function Hh(i,t,{high:e,wide:n}){if(!i.length)return null;let s=t.clone().normalize(),r=new A().crossVectors(new A(0,0,1),s).normalize(),o=new A().crossVectors(s,r),a=h=>{let u=i.map(d=>d.dot(h));return(Math.min(...u)+Math.max(...u))/2},l=new A().addScaledVector(r,a(r)).addScaledVector(o,a(o)).addScaledVector(s,a(s)),c=()=>Math.max(.1,...i.map(h=>{let u=h.clone().sub(l);return u.dot(s)+_T*Math.max(Math.abs(u.dot(r))/n,Math.abs(u.dot(o))/e)}));for(let h=0;h<3;h++){let u=c(),d=x=>{let m=i.map(g=>{let v=g.clone().sub(l);return v.dot(x)/Math.max(.05,u-v.dot(s))});return(Math.min(...m)+Math.max(...m))/2*u},[f,p]=[d(r),d(o)];l.addScaledVector(r,f).addScaledVector(o,p)}return{target:l,eye:l.clone().addScaledVector(s,c())}}var Gi=256,ST=.24,Yf=4,TT=.04,ET=.05,Vi=null;function cx(){if(Vi)return Vi;let i=document.createElement("canvas");i.width=i.height=Gi;let t=i.getContext("2d"),e=t.createImageData(Gi,Gi);for(let n=0;n<Gi;n++)for(let s=0;s<Gi;s++){let r=Math.floor(Yf*n/Gi),o=2*Math.PI*s/Gi,a=n+5*Math.sin(o+2.1*r)+2*Math.sin(2*o+r),l=.5+.25*Math.sin(.55*a+3*r)+.25*Math.sin(1.63*a+r),c=Yf*n%Gi<Yf?.06:0,h=255*(1-TT*Math.abs(Math.sin(5.3*r+1))-ET*l**3-c);e.data.set([h,h,h,255],4*(Gi*n+s))}return t.putImageData(e,0,0),Vi=new Li(i),Vi.wrapS=Vi.wrapT=Cr,Vi.repeat.setScalar(1/ST),Vi.colorSpace=qe,Vi.anisotropy=4,Vi}var Sn=.0015,Zf=[.005*za[0],.005*za[1]],AT=.2,RT=.03,CT=/board|table|wood|desk|counter/i;function eo(i,t=Sn){let e=ve(i);return Array.from({length:e.length/2},(n,s)=>[e[2*s],e[2*s+1],t])}var Wh=class{constructor(t,{head:e,meshes:n}){this.round=t;let{plan:s}=t;this.group.add(this.bodies);for(let{part:r,...o}of s.scene){let a=zi(o,n),l=r==="obstacle",c=new ae(a,this.keep(yn(new Nn,1.015),l?"obstacle":"carrier"));c.receiveShadow=c.castShadow=!0,l&&this.obstacles.push(c);let h=this.own(new ea(a,30)),u=new Br(h,this.keep(yn(new Ps({transparent:!0,opacity:.4}),1.01),"obstacle-line"));o.kind!=="mesh"&&this.geometries.push(a),this.bodies.add(qs(c,o.pose)),this.group.add(qs(u,o.pose))}this.addSurface(CT.test(e?.task?.surface??"")),this.addGoal(),s.strokes.forEach(r=>{let o=this.keep(new He({linewidth:6,transparent:!0,opacity:.35}),"stroke"),a=qn(xs(gs(s.surface.shape,eo(r,2*Sn),!1),!1),o);this.geometries.push(a.geometry),this.strokes.push(a),this.strokeGroup.add(a)}),this.group.add(qs(this.strokeGroup,s.surface.pose))}round;group=new te;bodies=new te;obstacles=[];sights=null;surface=null;outlines=new Map;strokes=[];strokeGroup=new te;materials=[];geometries=[];show(t,e,n,s){let{truth:r}=this.round,o=r?.surface??null,{shape:a}=this.round.plan.surface;for(let l of this.outlines.values())l.visible=!1;n&&t.found&&this.showOutline(n,()=>this.outlineAt(n,a,"found",.28)),o&&t.actual&&this.showOutline(o,()=>this.outlineAt(o,sr(r,a),"actual",0)),this.strokeGroup.visible=t.strokes||s!==null,this.strokes.forEach((l,c)=>{l.visible=t.strokes||c===s,l.material.linewidth=c===s?7:c===e?9:6,l.material.opacity=c===s?1:c===e?.6:.35})}showOutline(t,e){let n=this.outlines.get(t);n||(n=e(),this.outlines.set(t,n),this.group.add(n)),n.visible=!0}fade(t){if(!(!this.surface||!this.obstacles.length)){this.sights??=this.makeSights(this.surface);for(let e of this.obstacles){let[n]=Gh([e]),s=n!==void 0&&this.sights.some(r=>qf(n,r,t));e.material.transparent=s,e.material.opacity=s?AT:1,e.material.depthWrite=e.castShadow=!s}}}paint(){for(let t of this.materials)t.color.set(gt(t.name))}dispose(){for(let t of this.materials)t.dispose();for(let t of this.geometries)t.dispose()}keep(t,e){return t.name=e,t.color.set(gt(e)),this.materials.push(t),t}own(t){return this.geometries.push(t),t}get rings(){return this.round.plan.surface.rings.map(t=>eo(t)).filter(t=>t.length>=3)}face(){let t=this.round.plan.surface.shape;if(t?.kind==="mesh")return Ua(t).geometry;let[e,...n]=this.rings.map(r=>r.map(([o,a])=>new st(o,a)));if(!e)return null;let s=new Ni(e);return s.holes=n.map(r=>new Ni(r)),this.own(Gf(t,new Os(s)))}makeSights(t){this.group.updateMatrixWorld(!0);let e=Xs([t]),n=Vh(e);return[n,...e.map(s=>s.lerp(n,.1))].map(s=>s.clone().addScaledVector(ms(this.round.plan.surface,s),RT))}addSurface(t){let{pose:e,shape:n}=this.round.plan.surface,s=this.face();if(!s)return;let r=new Nn({side:cn,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1});t&&!n&&(r.map=cx()),this.surface=qs(new ae(s,this.keep(r,t?"surface-3d":"sheet-3d")),e),this.surface.receiveShadow=!0,this.bodies.add(this.surface);let o=this.rings.flatMap(l=>xs(gs(n,l,!0),!0)),a=qn(o,this.keep(new He({linewidth:2}),"outline"));this.geometries.push(a.geometry),this.group.add(qs(a,e))}outlineAt(t,e,n,s){let r=qs(new te,t),o=this.keep(new He({linewidth:s?3:2}),n),a=this.rings.flatMap(h=>xs(gs(e,h.map(([u,d,f])=>[u,d,f+(s?1:2)*Sn]),!0),!0)),l=qn(s?a:Uh(a,Zf),o);this.own(l.geometry),r.add(l);let c=s?this.face():null;if(c){let h=new Nn({transparent:!0,opacity:s,depthWrite:!1});r.add(new ae(c,this.keep(h,n)))}return r}addGoal(){let{goal:t,surface:e}=this.round.plan;if(t?.kind!=="collected")return;let[n,s]=t.place,r=qs(new te,e.pose),o=(a,l,c)=>{let h=new Nn({transparent:!0,opacity:l,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-3,polygonOffsetUnits:-3});a.translate(n,s,Sn);let u=new ae(this.own(Gf(e.shape,a)),this.keep(h,c));r.add(u)};o(new ss(t.radius,48),.22,"goal"),o(new ks(Math.max(0,t.radius-.003),t.radius,48),1,"goal-line"),o(new ss(Math.min(.006,.3*t.radius),24),1,"goal-line"),this.group.add(r)}};function qs(i,t){return i.matrixAutoUpdate=!1,ce(t,i.matrix),i}var tp=.007,PT=600,IT=5.5,LT=18,DT=.03,jf=1500,NT=1.7,kT=.6,OT=.35,$h=.4,bI=$h+.32*(1-$h),Jf=["position","normal"],no=(i,t)=>i.getAttribute(t);function ux(i){return/crumb|chip|sand|gravel|debris/i.test(i??"")?"crumb":/water|detergent|soap|juice|milk/i.test(i??"")?"drop":null}function Qf(i,t){let e=Math.sin(12.9898*i+78.233*t)*43758.5453;return e-Math.floor(e)}var Kf=(i,t,e,n)=>new ki(1,i,t,0,2*Math.PI,0,e*Math.PI).rotateX(Math.PI/2).translate(0,0,-Math.cos(e*Math.PI)).scale(1,1,n);function hx(i){let t=no(i,"position");for(let e=0;e<t.count;e++){let n=1-OT*Qf(Math.round(20*t.getX(e)),Math.round(20*t.getY(e))+Math.round(20*t.getZ(e)));t.setXYZ(e,n*t.getX(e),n*t.getY(e),n*t.getZ(e))}return i.deleteAttribute("normal")}function FT(){let i=new ss(NT,8),{count:t}=i.getAttribute("position");return i.setAttribute("color",new re(Float32Array.from({length:4*t},(e,n)=>n===3?kT:0),4)),i.deleteAttribute("normal")}var Xh=class{mesh;shape=null;capacity=0;constructor(t){this.mesh=new ae(new Ft,t),this.mesh.frustumCulled=!1}place(t,e,n,s){let r=e.length/2;(this.shape!==t||this.capacity<r)&&this.reserve(t,2*r);let{geometry:o}=this.mesh;for(let a=0;a<r;a++)UT(o,t,a,n,s,e[2*a],e[2*a+1]);for(let a of Jf)o.hasAttribute(a)&&(no(o,a).needsUpdate=!0);o.setDrawRange(0,r*t.index.count)}reserve(t,e){this.mesh.geometry.dispose();let n=new Ft,[s,r]=[no(t,"position").count,t.index];for(let o of[...Jf,"color"].filter(a=>t.hasAttribute(a))){let{array:a,itemSize:l}=no(t,o);n.setAttribute(o,new re(Float32Array.from({length:a.length*e},(c,h)=>a[h%a.length]),l))}n.setIndex(new re(Uint32Array.from({length:r.count*e},(o,a)=>r.array[a%r.count]+s*Math.floor(a/r.count)),1)),this.mesh.geometry=n,[this.shape,this.capacity]=[t,e]}},qh=class{group=new te;few;many;shadow=FT();grains;shadows=new Xh(new ln({vertexColors:!0,transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2}));drawn={places:null,radius:0};constructor(t){[this.few,this.many]=t==="crumb"?[hx(Kf(5,3,.62,.85)),hx(new Ls(1,1,4,1,!0).rotateX(Math.PI/2).translate(0,0,.5))]:[Kf(8,3,.5,.55),Kf(6,2,.5,.55)],this.grains=new Xh(new fa(t==="crumb"?{flatShading:!0,specular:6710886,shininess:8}:{specular:10066329,shininess:60})),this.group.matrixAutoUpdate=!1,this.group.add(this.grains.mesh,this.shadows.mesh),this.paint()}paint(){let{color:t,emissive:e}=this.grains.mesh.material;t.set(gt("believed")),e.copy(t).multiplyScalar($h),t.multiplyScalar(1-$h)}show(t,e,n,s){if(this.group.visible=t!==null&&t.length>0,!t||!this.group.visible)return;ce(e,this.group.matrix),this.group.matrixWorldNeedsUpdate=!0;let r=t.length/2,o=tp*Math.min(1,Math.sqrt(PT/r)),a=Math.min(LT/s,Math.max(IT/s,o))/2;this.drawn.places===t&&Math.abs(a/this.drawn.radius-1)<DT||(this.drawn={places:t,radius:a},this.grains.place(r<jf?this.few:this.many,t,a,n),this.shadows.mesh.visible=r<jf,r<jf&&this.shadows.place(this.shadow,t,a,n))}};function UT(i,t,e,n,s,r,o){let[a,l,c]=oi(s,r,o,0),[h,u,d]=s?oi(s,r,o,1):[a,l,c+1],[f,p,x]=[h-a,u-l,d-c],m=2*Math.PI*Qf(r,o),g=n*(.75+.5*Qf(o,r)),[v,S]=[Math.cos(m),Math.sin(m)],b=v*f+S*p,T=Math.sqrt(1-Math.min(.99,b*b)),[R,y,E]=[(v-b*f)/T,(S-b*p)/T,-b*x/T],[D,P,k]=[p*E-x*y,x*R-f*E,f*y-p*R];for(let O of Jf){if(!t.hasAttribute(O))continue;let[B,I,V,X]=O==="position"?[g,a,l,c]:[1,0,0,0],[H,et]=[no(t,O).array,no(i,O).array];for(let $=0,J=e*H.length;$<H.length;$+=3,J+=3){let[tt,wt,Nt]=[B*H[$],B*H[$+1],B*H[$+2]];et[J]=I+tt*R+wt*D+Nt*f,et[J+1]=V+tt*y+wt*P+Nt*p,et[J+2]=X+tt*E+wt*k+Nt*x}}}var bn=({plan:{goal:i}})=>i?.kind==="polished"||i?.kind==="dispensed",_i=({plan:{goal:i}})=>i?.kind==="dispensed"?"coat thickness":"passes",Ga=.51,Ys={little:"too little",allowed:"allowed",much:"too much"},Yh={little:4,allowed:3,much:2};function dx(i,t,e,n){let s=n?Math.min(e,t-i):e,r=Array.from({length:s},(o,a)=>i+(t-i)*a/s);return n?r.map(Math.floor):r}function ys({unit:i,low:t,high:e,target:n}){let s=i==="passes",r=s?e+1:e,o={little:dx(0,t,Yh.little,s),allowed:dx(t,r,Yh.allowed,s),much:[r,s?r+Math.max(1,e-t):e+2*(e-n)]},a=(h,u,d)=>{let[f,p]=[h==="little"&&d<Yh.little?2:1,Yh[h]];return f+Math.round(u*(p-f)/Math.max(1,d-1))},l=Object.keys(o).flatMap(h=>o[h].map((u,d,{length:f})=>({degree:h,from:u,colour:`${h}-${a(h,d,f)}`}))),c=h=>String(s?h:Number(h.toPrecision(h<100?2:3)));return l.map((h,u)=>{let d=l[u+1]?.from,f=d===void 0?null:s?d-1:d;return{...h,label:f===null?`\u2265 ${c(h.from)}`:f===h.from?c(f):`${c(h.from)}\u2013${c(f)}`}})}function vs(i,{unit:t,target:e},n){let s=t==="passes"?Math.round(n):n,r=1e-6*e,o=0;return i.forEach(({degree:a,from:l},c)=>{(a==="much"&&t!=="passes"?s>l+r:s>=l-r)&&(o=c)}),o}function Va(i,t){let e=ys(i);return t.map(n=>e[vs(e,i,n)].degree)}var Ha=(i,t)=>i.filter(e=>e===t).length/Math.max(1,i.length),px=({unit:i,low:t,high:e})=>t===e?`${t} ${i}`:`${t} to ${e} ${i}`,fx=new WeakMap;function vn(i,t){if(!i||!t||t.length!==i.places.length/2)return null;let e=fx.get(t);if(e)return e;let n=t.map(s=>sn(s)*i.step);return fx.set(t,n),n}function Zh(i,t,e,n){let s=i.endedAt(t);if(s?.plan.treatment){let{interpreted:a,truth:l,plan:{treatment:c,surface:h}}=s,u=a?.found??h.pose,d=`${_i(s)} after round ${s.number}`,f=n.actual?vn(c,l?.treated):null;if(f)return{kind:"true",title:`True ${d}`,record:c,values:f,pose:l?.surface??u,shape:sr(l,h.shape)};let p=n.estimated?vn(c,a?.treated):null;if(p)return{kind:"estimated",title:`Estimated ${d}: mean of the belief`,record:c,values:p,pose:u,shape:h.shape}}let{treatment:r,surface:o}=e.plan;return!n.believed||!r||!e.treated?null:{kind:"predicted",title:`Predicted ${_i(e)}`,record:r,values:e.treated.at(t-e.start),pose:o.pose,shape:o.shape}}var jh=["believed","estimated","actual","seen"],ep={believed:6,estimated:12,actual:8,seen:14},BT={believed:i=>{i.arc(32,32,28,0,2*Math.PI),i.fill()},estimated:i=>{i.lineWidth=9,i.arc(32,32,25,0,2*Math.PI),i.stroke()},actual:i=>{i.lineWidth=15,i.moveTo(10,10),i.lineTo(54,54),i.moveTo(54,10),i.lineTo(10,54),i.stroke()},seen:i=>{i.lineWidth=7,i.rect(6,6,52,52),i.stroke()}};function Jh(i){let t=document.createElement("canvas");t.width=t.height=64;let e=t.getContext("2d");return e.fillStyle=e.strokeStyle="#fff",e.beginPath(),i(e),new Li(t)}var Qh=()=>Jh(i=>{i.arc(32,32,24,0,2*Math.PI),i.fill(),i.lineWidth=5,i.strokeStyle="#000",i.stroke()});function zT(i){let t=new Wn({size:ep[i],sizeAttenuation:!1,map:Jh(BT[i]),alphaTest:.15,transparent:!0});return yn(t,.99)}var Kh=class{group=new te;points;shown=new Map;grains=null;outcome={key:"",outcome:null};constructor(){this.points=Object.fromEntries(jh.map(t=>{let e=new ni(new Ft,zT(t));return e.matrixAutoUpdate=!1,e.frustumCulled=!1,e.renderOrder=2+jh.indexOf(t),this.group.add(e),[t,e]})),this.paint()}paint(){for(let t of jh)this.points[t].material.color.set(gt(t));this.grains?.paint()}show(t,e,{round:n,time:s},r,o){let a=Math.min(1.25,Math.max(.7,tp*o/ep.believed));for(let g of jh)this.points[g].material.size=a*ep[g];let l=`${t.version} ${t.rounds.filter(g=>g.end<=e+1e-6).length}`;l!==this.outcome.key&&(this.outcome={key:l,outcome:t.outcomeAt(e)});let{outcome:c}=this.outcome,{pose:h,shape:u}=n.plan.surface,d=!bn(n),f=d&&r.believed?n.particles.at(s):null,p=ux(t.head?.task?.medium);p&&!this.grains&&(this.grains=new qh(p),this.group.add(this.grains.group)),this.grains?.show(f,h,u,o),this.set("believed",this.grains?null:f,h,u,1);let x=c?.pose??h,m=t.endedAt(e)||e<n.start+n.firstContact?1:.45;this.set("estimated",d&&r.estimated?c?.estimated??null:null,x,c?.shape,m),this.set("actual",d&&r.actual?c?.actual??null:null,c?.actualPose??x,c?.actualShape,m),this.set("seen",r.seen?c?.seen??null:null,x,c?.shape,m)}set(t,e,n,s,r){let o=this.points[t];if(o.visible=e!==null&&e.length>0,!e||!o.visible||(ce(n,o.matrix),o.matrixWorldNeedsUpdate=!0,o.material.opacity=r,this.shown.get(t)===e))return;this.shown.set(t,e);let a=e.length/2,l=o.geometry.getAttribute("position");(!l||l.count<a)&&(o.geometry.dispose(),l=new re(new Float32Array(3*Math.max(64,2*a)),3),o.geometry.setAttribute("position",l));for(let c=0;c<a;c++)l.setXYZ(c,...oi(s,e[2*c],e[2*c+1],Sn));l.needsUpdate=!0,o.geometry.setDrawRange(0,a)}};var mx={low:.8,high:1.25},GT=.006,VT=.12,HT=2.2,WT=.15,$T=.5,io=[{colour:"force-little",label:"below 80\u202F%"},{colour:"force-target",label:"on target"},{colour:"force-much",label:"above 125\u202F%"}],XT=io.length;function qT(i,t){return t===null?XT:i<mx.low*t?0:i<=mx.high*t?1:2}var tu=class{constructor(t,e){this.most=t;this.target=e;let{geometry:n}=this.mesh;this.corners=new re(new Float32Array(12*t),3),this.colours=new re(new Float32Array(16*t),4),n.setAttribute("position",this.corners),n.setAttribute("color",this.colours),n.setIndex(Array.from({length:6*t},(s,r)=>4*Math.floor(r/6)+[0,1,2,2,1,3][r%6])),this.mesh.frustumCulled=!1,this.mesh.renderOrder=1,this.paint()}most;target;mesh=new ae(new Ft,new ln({vertexColors:!0,side:cn,transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-8,polygonOffsetUnits:-8}));times=new nn(!0,64);degrees=[];corners;colours;end=null;peak=0;selected=null;palette=[];clear(){this.breakOff(),this.times.length=this.degrees.length=0}breakOff(){this.end=null,this.peak=0}push(t,e,n,s,{step:r,reference:o}){this.peak=Math.max(this.peak,s);let a=GT*Math.min(HT,Math.max(VT,this.peak/o)),l=this.end??={place:e,half:a,way:null,corners:null};if(e.distanceTo(l.place)<r||this.times.length===this.most)return;let c=e.clone().sub(l.place).normalize(),h=n.clone().cross(c).normalize(),u=(x,m)=>[x.clone().addScaledVector(h,m),x.clone().addScaledVector(h,-m)],d=l.corners&&l.way.dot(c)>$T?l.corners:u(l.place,l.half),f=u(e,a),p=this.times.length;[...d,...f].forEach(({x,y:m,z:g},v)=>this.corners.setXYZ(4*p+v,x,m,g)),this.corners.needsUpdate=!0,this.times.push(t),this.degrees.push(qT(this.peak,this.target)),this.colour(p),this.end={place:e,half:a,way:c,corners:f},this.peak=0}show(t,e){let n=Math.max(t,this.selected?.[1]??-1/0),s=Gn(this.times.data,n,this.times.length)+1;this.mesh.visible=e&&s>0,this.mesh.geometry.setDrawRange(0,6*s)}select(t){this.selected=t;for(let e=0;e<this.times.length;e++)this.colour(e)}get counts(){let t=this.mesh.visible?this.mesh.geometry.drawRange.count/6:0;return{drawn:t,lit:Array.from({length:t},(e,n)=>n).filter(e=>this.isLit(e)).length}}paint(){this.palette=[...io.map(t=>t.colour),"contact"].map(t=>new Mt(gt(t)));for(let t=0;t<this.times.length;t++)this.colour(t)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}isLit(t){let[e,n]=this.selected??[-1/0,1/0];return this.times.data[t]>=e&&this.times.data[t]<=n}colour(t){let{r:e,g:n,b:s}=this.palette[this.degrees[t]];for(let r=0;r<4;r++)this.colours.setXYZW(4*t+r,e,n,s,this.isLit(t)?1:WT);this.colours.needsUpdate=!0}};var gx=.0015,xx=4e3,YT=5,ZT=.1,jT=11,yx={none:0,contact:1,pushed:2},vx=()=>["lifted","contact","pushed"].map(i=>new Mt(gt(i))),eu=class{constructor(t){this.round=t;this.ribbon=new tu(xx,t.target),this.object.add(this.lines.line,this.ribbon.mesh)}round;object=new te;ribbon;lines=new to(3,vx());times=new nn(!0);taken=0;step=gx;last=null;kind=yx.none;basis="";show(t,e){this.grow();let n=Gn(this.times.data,t,this.times.length)+1;this.lines.show(e.path?n:0),this.ribbon.show(t,e.ribbon)}paint(){this.lines.paint(vx()),this.ribbon.paint()}dispose(){this.lines.dispose(),this.ribbon.dispose()}between(t,e){let n=[],{round:s}=this,r=Math.max(1,Math.floor(s.count/2e4)),o=null;for(let a=Math.max(0,s.place(t)[0]);a<s.count&&s.t.data[a]<=e;a+=r){let{place:l}=this.place(a);o&&n.push(...o.toArray(),...l.toArray()),o=l}return n}nearest(t,e,n,s,r,o){let[a,l]=[r**2,null];for(let c=0;c<this.times.length&&this.times.data[c]<=s;c++){if(o&&!this.round.isPressed(this.times.data[c]))continue;let h=t(this.lines.end(c)),u=(h.x-e)**2+(h.y-n)**2;u<=a&&([a,l]=[u,this.times.data[c]])}return l}place(t){let{data:e}=this.round.tool,n=new A(e[7*t],e[7*t+1],e[7*t+2]),s=ms(this.round.plan.surface,n);return{place:n.addScaledVector(s,1.5*Sn),normal:s}}press(t,{place:e,normal:n}){let{round:s,step:r}=this,o=s.height.data[t],a=Number.isFinite(o)?e.clone().addScaledVector(n,-o):e,l=s.target??Math.max(YT,s.normal.largest);this.ribbon.push(s.t.data[t],a,n,s.normal.data[t],{step:r,reference:l})}restart(){this.taken=0,this.last=null,this.lines.clear(),this.times.length=0,this.ribbon.clear()}grow(){let{round:t}=this;this.basis!==t.basis&&this.restart(),this.basis=t.basis;let e=t.over||t.interpreted?t.count:t.count-ml+1;for(;this.taken<e;){let n=this.taken++,s=t.t.data[n],r=this.place(n),{place:o}=r;if(!Number.isFinite(o.x+o.y+o.z))continue;t.isPressed(s)&&Number.isFinite(t.normal.data[n])?this.press(n,r):this.ribbon.breakOff();let a=yx[t.contactAt(s)];this.last&&this.last.distanceToSquared(o)<this.step**2&&(a===this.kind||this.step>2*gx)||(this.last&&(this.lines.push([...this.last.toArray(),...o.toArray()],a),this.times.push(s)),this.last=o,this.kind=a,this.lines.count>xx&&(this.step*=2,this.restart()))}}},KT=6,np=i=>`track-${i%KT+1}`,nu=class{group=new te;list=[];show(t){this.list=t,ru(this.group),t.forEach(({points:e,samples:n,color:s},r)=>{let o=new He({linewidth:4.5,transparent:!0,polygonOffset:!0,polygonOffsetFactor:-12,polygonOffsetUnits:-12});o.color.set(su(s,r));let a=qn(xs(e,!1),o);a.renderOrder=6,this.group.add(a),n?.length&&this.group.add(bx(n,su(s,r)))})}paint(){this.show(this.list)}},iu=class{group=new te;show(t){ru(this.group);for(let{pose:e,color:n}of t){let s=ce(e),r=new A().setFromMatrixPosition(s).toArray();for(let[o,a]of["axis-x","axis-y","axis-z"].entries()){let l=new He({linewidth:3.5});l.color.set(gt(a));let c=new A().setComponent(o,ZT).applyMatrix4(s).toArray();this.group.add(qn([...r,...c],l))}this.group.add(bx([r],Hi(n,gt("axis-z"))))}}};function bx(i,t){let e=new Ft().setAttribute("position",new Vt(i.flat(),3)),n=new Wn({size:jT,sizeAttenuation:!1,map:Qh(),alphaTest:.3,transparent:!0});n.color.set(t);let s=new ni(e,yn(n,.98));return s.frustumCulled=!1,s.renderOrder=7,s}function ru(i){for(let t of[...i.children]){let{geometry:e,material:n}=t;e.dispose(),n.dispose(),i.remove(t)}}var Hi=(i,t)=>i&&/^#[0-9a-f]{3,8}$/i.test(i)?i:t,su=(i,t)=>Hi(i,gt(np(t)));var Wi=400,Zs=220,[so,ip,sp,Wa]=[52,12,10,38],li=27,js=130,_x=20,JT=21;function wx(i,t){let e=a=>a?.map(([l,c])=>[t(l),c]),n={...i,amounts:e(i.amounts),spans:e(i.spans)},s=n.title||n.id||n.diagram,r=n.amounts?n.diagram==="piechart"?tE(n.amounts):QT(n.amounts):n.spans?eE(n.spans):nE(n);r.setAttribute("role","img"),r.setAttribute("aria-label",`${n.diagram}: ${s}`);let o=[n.x_label,n.y_label].filter(a=>a);return _("figure",{class:"s-plot"},_("figcaption",{},s),r,o.length?_("p",{class:"w-quiet"},o.join(" / ")):null)}var bs=i=>Number.isInteger(i)?Gt(i,0):Gt(i,Math.abs(i)<10?3:1),Xa=(i,...t)=>ot("svg",{viewBox:`0 0 ${Wi} ${i}`},...t),On=(i,t,e,n="start")=>ot("text",{x:i,y:t,"text-anchor":n,fill:"var(--ink)","font-size":11.5},e),rp=(i,t,e,n="end")=>{let[s="",r]=e.split(`
`);if(!r)return[On(i,t,$a(s,_x),n)];let o=ot("text",{x:i,y:t+6,"text-anchor":n,fill:"var(--quiet)","font-size":9.5},$a(r,JT));return[On(i,t-5,$a(s,_x),n),o]},Mx=i=>i.replace(`
`,", "),$a=(i,t)=>i.length>t?`${i.slice(0,t-1)}\u2026`:i;function QT(i){let[t,e]=[Math.min(0,...i.map(([,s])=>s)),Math.max(0,...i.map(([,s])=>s))],n=s=>js+(Wi-js-52)*(s-t)/(e-t||1);return Xa(i.length*li+6,...i.flatMap(([s,r],o)=>{let a=o*li+4,[l,c]=r<0?[n(r),n(0)]:[n(0),n(r)];return[...rp(js-6,a+13,s),ot("rect",{x:l,y:a,width:Math.max(1,c-l),height:li-6,rx:3,fill:"var(--believed)"},ot("title",{},`${Mx(s)}: ${r}`)),On(c+5,a+13,bs(r))]}))}function tE(i){let t=i.reduce((l,[,c])=>l+c,0)||1,[e,n,s]=[90,92,82],r=-Math.PI/2,o=l=>`${e+s*Math.cos(l)} ${n+s*Math.sin(l)}`,a=Math.max(2*n,i.length*li+10);return Xa(a,...i.flatMap(([l,c],h)=>{let u=r;r+=2*Math.PI*c/t;let d=`var(--${np(h)})`;return[c>=t?ot("circle",{cx:e,cy:n,r:s,fill:d}):ot("path",{d:`M${e} ${n}L${o(u)}A${s} ${s} 0 ${r-u>Math.PI?1:0} 1 ${o(r)}Z`,fill:d,stroke:"var(--paper)"}),ot("rect",{x:190,y:h*li+4,width:12,height:12,fill:d}),...rp(208,h*li+14,l,"start"),On(Wi-4,h*li+14,`${bs(c)} (${Gt(100*c/t,0)} %)`,"end")]}))}function eE(i){let t=Math.min(...i.map(([,[r]])=>r)),e=Math.max(...i.map(([,[,r]])=>r)),n=r=>js+(Wi-js-10)*(r-t)/(e-t||1),s=i.length*li+22;return Xa(s,...i.flatMap(([r,[o,a]],l)=>[...rp(js-6,l*li+17,r),ot("rect",{x:n(o),y:l*li+4,width:Math.max(2,n(a)-n(o)),height:li-8,rx:3,fill:"var(--event)"},ot("title",{},`${Mx(r)}: ${bs(a-o)} s`))]),On(js,s-4,"0 s"),On(Wi-10,s-4,`${bs(e-t)} s`,"end"))}function nE({points:i=[],diagram:t,x_label:e,y_label:n}){let s=d=>{let f=i.map(m=>m[d]),[p,x]=[Math.min(...f),Math.max(...f)];return p<x?[p,x]:[p-.5,x+.5]};if(!i.length)return Xa(30,On(8,18,"no points"));let[[r,o],[a,l]]=[s(0),s(1)],c=d=>so+(Wi-so-ip)*(d-r)/(o-r),h=d=>Zs-Wa-(Zs-sp-Wa)*(d-a)/(l-a),u=t==="linechart"?[ot("path",{d:i.map(([d,f],p)=>`${p?"L":"M"}${c(d).toFixed(1)} ${h(f).toFixed(1)}`).join(""),fill:"none",stroke:"var(--believed)","stroke-width":1.8})]:i.map(([d,f])=>ot("circle",{cx:c(d),cy:h(f),r:2.6,fill:"var(--believed)","fill-opacity":.7}));return Xa(Zs,ot("path",{d:`M${so} ${sp}V${Zs-Wa}H${Wi-ip}`,fill:"none",stroke:"var(--rule)"}),...u,On(so-5,h(a),bs(a),"end"),On(so-5,h(l)+9,bs(l),"end"),On(so,Zs-Wa+15,bs(r)),On(Wi-ip,Zs-Wa+15,bs(o),"end"),On(Wi/2,Zs-5,$a(e,40),"middle"),On(4,sp+22,$a(n,30)))}var iE=.95,ap=.001,sE=([i,t],[e,n])=>i<=n+ap&&t>=e-ap;function _s({about:i,view:t},e){let n=new Map,s=o=>n.set(o,(n.get(o)??0)+1),r=e===null?i:[i[e]??[]];for(let o of r)for(let a of new Set(o.map(({episode:l})=>l)))s(a);if(e===null&&t)for(let{episode:o}of[...t.tracks,...t.bodies,...t.particles])s(o);return[...n].sort((o,a)=>a[1]-o[1]).map(([o])=>o)}function ou(i,t,e,n){let s=i.view,r=s?.episodes.find(h=>h.id===e),o={trajectories:[],ghosts:[],frames:[],intervals:[],particles:[],since:[]};if(!s||!r)return o;let a=h=>aE(n,r.rounds??[r.interval[0]],h),l=oE(t===null?i.about.flat():i.about[t]??[],e,r.interval);for(let{interval:h,class:u}of l)h&&o.intervals.push({start:a(h[0]),end:a(h[1]),label:rE(u)});let c=h=>t===null||!l.length||l.some(u=>u.interval&&sE(u.interval,h));for(let{episode:h,thing:u,interval:d,path:f,samples:p,strong:x,colour:m}of s.tracks){if(h!==e||!c(d))continue;let g=`${lp(u)} ${oe(a(d[0]))} to ${oe(a(d[1]))}`,v=p.map(([,S,b,T])=>[S,b,T]);o.trajectories.push({name:g,points:f.length>1?f:v,samples:v,...op(x,m)})}for(let{episode:h,thing:u,kind:d,time:f,pose:p,strong:x,colour:m}of s.bodies)h!==e||!c([f,f])||(d==="robot"||d==="tool"?o.ghosts.push({time:a(f),...op(x,m)}):o.frames.push({name:`${lp(u)} at ${oe(a(f))}`,time:a(f),pose:p,...op(x,m)}));for(let{episode:h,round:u,state:d,positions:f,colour:p}of s.particles){let x=n.rounds.find(b=>b.number===u),m=r.rounds?.[u-1]??r.interval[0];if(h!==e||!x||!c([m,m+x.length]))continue;let g=d==="before",v=`${g?"dirt before":"estimated dirt after"} round ${u}, as queried`,S=(g?null:x.interpreted?.found)??x.plan.surface.pose;o.particles.push({name:v,state:d,pose:S,shape:x.plan.surface.shape,places:f,...p?{color:p}:{}}),o.since.push(g?x.start:x.end)}if(o.ghosts=[...new Map(o.ghosts.map(h=>[h.time,h])).values()].sort((h,u)=>h.time-u.time),!o.intervals.length)for(let[h,u]of r.shown)o.intervals.push({start:a(h),end:a(u),label:"shown"});return o}var op=(i,t)=>t?{color:t}:i?{color:gt("highlight")}:{},rE=i=>i.replace(/([a-z])(?=[A-Z])/g,"$1 ").toLowerCase();function oE(i,t,[e,n]){let s=new Set;return i.filter(({episode:r,interval:o,class:a})=>{if(r!==t||!o)return!1;let l=`${a} ${o.join()}`;return s.has(l)||o[1]-o[0]>iE*(n-e)?!1:(s.add(l),!0)})}function aE(i,t,e){let n=t.findLastIndex(r=>r<=e+ap);n=Math.max(0,n);let s=i.rounds.find(({number:r})=>r===n+1)??i.rounds.at(-1);return s?Math.min(s.end,Math.max(s.start,s.start+e-t[n])):0}function au(i,{trajectories:t,ghosts:e,frames:n,intervals:s,particles:r,since:o}){i.clearShown(),i.showTrajectories(t),i.showRobotAt(e),i.showFrames(n),i.showParticles(r),i.highlight(s);let a=[[...e,...n].map(({time:l})=>l),s.map(({start:l})=>l),o].find(l=>l.length);a&&i.seek(Math.min(...a))}var lp=i=>i.replace(/^[a-z]+:/,""),cp=i=>/\d{8}-\d{6}-[0-9a-f]{4}/.exec(i)?.[0]??null,hp=({names:i},t)=>i[t]??lp(t).replace(/_(\d{8}-\d{6}-[0-9a-f]{4})-(\d+)$/," $2"),up=i=>new Date(1e3*i).toLocaleString("en-GB",{day:"numeric",month:"short",hour:"2-digit",minute:"2-digit"}),dp=({task:i,begun:t})=>`${i}, ${up(t)}`;var fp=200,lE=8,cE=3,hE=1e9,uE=1e10,Sx={share:["%",100],rad:["\xB0",180/Math.PI],m:["mm",1e3],"m per episode":["mm per episode",1e3]};function qa(i){let{view:t,about:e}=i;return!!t&&_s(i,null).length>0&&(t.tracks.length>0||t.bodies.length>0||t.particles.length>0||e.some(n=>n.some(({interval:s})=>s)))}function lu(i,t){let{rows:e,columns:n,holds:s,more:r,seconds:o,printed:a,remarks:l,view:c,about:h}=i,u=s?`${e.length}${r?" or more":""} ${e.length===1?"answer":"answers"}`:"No answer: false",d=[_("p",{class:"s-count"},_("b",{},u),o===void 0?"":` in ${Gt(o,2)} s`)];if(qa(i)){d.push(_("div",{class:"s-row"},_("button",{class:"w-button",type:"button",click:()=>t.show(i,null,null)},"Show all"),_("button",{class:"w-button",type:"button",click:()=>t.clear()},"Clear")));let p=_s(i,null);p.length>1&&d.push(_("div",{class:"s-in"},_("span",{class:"w-quiet"},"in "),...p.slice(0,lE).map(x=>_("button",{class:"s-chip",type:"button",title:x,click:()=>t.show(i,null,x)},dE(i,x)))))}let f=c?.left_out??0;f&&d.push(_("p",{class:"w-quiet s-remark"},`The picture is full: ${f} more queried ${f===1?"object is":"objects are"} not drawn.`));for(let p of l)d.push(_("p",{class:"w-quiet s-remark"},p));a&&d.push(_("pre",{class:"s-printed"},a));for(let p of c?.plots??[])d.push(wx(p,fE(i,p)));return e.length&&n.length?d.push(pE(i,t)):e.length&&h.every(p=>!p.length)&&d.push(_("p",{},"True.")),e.length>fp&&d.push(_("p",{class:"w-quiet"},`The table lists the first ${fp} of ${e.length} answers.`)),d}var Tx=({about:i},t)=>i.flat().find(({episode:e})=>e===t),dE=(i,t)=>{let e=Tx(i,t);return e?dp(e):t};function fE(i,{amounts:t=[],spans:e=[]}){let n=new Set([...t,...e].map(([s])=>cp(s)).filter(s=>s!==null));return s=>{let[r,o]=[cp(s),hp(i,s)];if(r===null||n.size<2)return o;let a=Tx(i,r);return`${o}
${a?`${up(a.begun)}, ${a.task}`:r}`}}function pE(i,t){let{rows:e,columns:n,units:s,about:r}=i,o=n.map((h,u)=>s[u]?`${h} [${Sx[s[u]]?.[0]??s[u]}]`:h),a=r.some(h=>h.length>0),l=_("tr",{},_("th",{scope:"col"},_("span",{class:"s-hidden"},"show")),...o.map(h=>_("th",{scope:"col"},h)),a&&_("th",{scope:"col"},"Episode")),c=e.slice(0,fp).map((h,u)=>{let d=r[u]??[],f=[...h.map((p,x)=>gE(i,p,s[x]??null)),...a?[mE(d)]:[]];return f.forEach((p,x)=>p.setAttribute("data-title",o[x]??"Episode")),_("tr",{},_("td",{},d.length?_("button",{class:"w-button s-show",type:"button","data-row":u,"aria-label":`Show answer ${u+1}`,click:()=>t.show(i,u,null)},"Show"):""),...f)});return _("div",{class:`s-table${n.length>cE?" s-stacks":""}`,tabindex:0,role:"group","aria-label":"Answers"},_("table",{},_("thead",{},l),_("tbody",{},...c)))}function mE(i){let t=new Map(i.map(e=>[e.episode,dp(e)]));return _("td",{title:[...t.keys()].join(", ")},[...t.values()].join("; "))}function gE(i,t,e){if(typeof t=="number"){let s=!e&&t>=hE&&t<uE,[,r]=Sx[e??""]??["",1],o=s?xE(t):Number.isInteger(t)&&!e?String(t):e==="share"?Gt(r*t,1):String(Number((r*t).toPrecision(e?3:5)));return _("td",{class:"s-number",title:`${t}${e&&e!=="share"?` ${e}`:""}`},o.replace("-","\u2212"))}if(t===null)return _("td",{class:"w-quiet"},"_");let n=Ex(i,t);return _("td",{title:typeof t=="string"?t:n},n)}var Ex=(i,t)=>t===null?"_":Array.isArray(t)?`[${t.map(e=>Ex(i,e)).join(", ")}]`:typeof t=="number"?String(Number(t.toPrecision(6))):hp(i,t),xE=i=>{let t=new Date(1e3*i);return`${t.toLocaleTimeString("en-GB")}.${String(t.getMilliseconds()).padStart(3,"0")}`};var pp=class{constructor(t){this.host=t}host;steps=new Map;draws=new Set;drawn=null;asked=!1;last=0;request(t){return this.steps.set(++this.last,t),this.ask(),this.last}now(){return performance.now()}cancel(t){this.steps.delete(t)}draw(t){this.draws.add(t),this.ask()}drop(t){this.draws.delete(t)}ask(){this.asked||this.drawn||(this.asked=!0,this.host.request(t=>this.run(t)))}run(t){this.asked=!1;let e=this.drawn=new Set,n=this.steps;this.steps=new Map;for(let s of n.values())Ax(()=>s(t));for(let s=this.next(e);s;s=this.next(e))this.draws.delete(s),e.add(s),Ax(s);this.drawn=null,(this.steps.size||this.draws.size)&&this.ask()}next(t){for(let e of this.draws)if(!t.has(e))return e;return null}};function cu(i,t){let e=-1/0,n,s=()=>{n=void 0,e=performance.now(),t()};return{ask:()=>{if(n!==void 0)return;let r=e+i-performance.now();r<=0?s():n=setTimeout(s,r)},stop:()=>clearTimeout(n)}}function Ax(i){try{i()}catch(t){reportError(t)}}var Yn=new pp({request:i=>requestAnimationFrame(i)});var ro=[.1,.25,.5,1,2,5,10],yE=1.15,mp={least:.12,most:.8},vE=3,oo=class{constructor(t=Yn){this.pictures=t}pictures;time=0;playing=!1;following=!1;speed=1;spans=new Set;callbacks=new Set;frame=null;before=0;late=0;known={edge:0,since:0,every:mp.least,pace:0};join(t){return this.spans.add(t),()=>{this.spans.delete(t)}}get duration(){return Math.max(0,...[...this.spans].map(t=>t.duration))}get end(){return Math.max(0,...[...this.spans].map(t=>t.now))}get edge(){let t=[...this.spans].filter(e=>e.live);return t.length?Math.max(0,...t.map(e=>e.now)):this.end}get isLate(){return this.playing&&this.late>1}get live(){return[...this.spans].some(t=>t.live)}subscribe(t){return this.callbacks.add(t),()=>this.callbacks.delete(t)}onGrowth(){this.following&&!this.live&&(this.following=!1,this.time=this.end),this.following&&(this.keepPace(),this.run()),this.notify()}seek(t){this.following=!1,this.time=Math.min(this.duration,Math.max(0,Number.isFinite(t)?t:0)),this.notify()}play(){if(this.time>=this.end-1e-6){if(this.live)return this.follow();this.time=0}this.playing=!0,this.following=!1,this.run(),this.notify()}pause(){this.playing=!1,this.following=!1,this.notify()}toggle(){this.playing||this.following?this.pause():this.play()}follow(){this.following=!0,this.playing=!1,this.known={edge:-1,since:this.pictures.now(),every:mp.least,pace:0},this.keepPace(),this.run(),this.notify()}setSpeed(t){this.speed=Math.min(10,Math.max(.1,t)),this.notify()}faster(t){let e=ro.reduce((n,s,r)=>Math.abs(s-this.speed)<Math.abs(ro[n]-this.speed)?r:n,0);this.setSpeed(ro[Math.min(ro.length-1,Math.max(0,e+t))])}destroy(){this.frame!==null&&this.pictures.cancel(this.frame),this.frame=null,this.callbacks.clear()}run(){this.frame===null&&(this.before=this.pictures.now(),this.late=0,this.frame=this.pictures.request(t=>this.step(t)))}step(t){this.frame=null;let e=Math.max(0,(t-this.before)/1e3);this.late=e>vE?this.late+1:0;let n=this.late?.25:e;if(this.before=Math.max(this.before,t),this.following){let{edge:r}=this,o=r-this.time,a=n*this.known.pace;this.time=Math.abs(o)<=Math.max(.001,a)?r:this.time+Math.sign(o)*a}else this.playing&&(this.time=Math.min(this.end,this.time+n*this.speed),this.time>=this.end&&(this.playing=!1,this.live&&this.follow()));(this.playing||this.following&&this.edge!==this.time)&&(this.frame=this.pictures.request(r=>this.step(r))),this.notify()}keepPace(){let{edge:t,known:e}=this;if(t===e.edge)return;let n=this.pictures.now(),{least:s,most:r}=mp,o=Math.min(r,Math.max(s,(n-e.since)/1e3)),a=e.edge<0?s:e.every+.3*(o-e.every);this.known={edge:t,since:n,every:a,pace:Math.abs(t-this.time)/(yE*a)}}notify(){for(let t of this.callbacks)t(this)}};function bE({mark:i,places:t},e){let[n,s]=[e.toFixed(1),(2*e).toFixed(1)],r={believed:"h0",estimated:`m-${n} 0a${n} ${n} 0 1 0 ${s} 0a${n} ${n} 0 1 0 -${s} 0`,actual:`m-${n} -${n}l${s} ${s}m0 -${s}l-${s} ${s}`,seen:`m-${n} -${n}h${s}v${s}h-${s}z`}[i],o="";for(let a=0;a+1<t.length;a+=2){let[l,c]=[1e3*t[a],-1e3*t[a+1]];Number.isFinite(l+c)&&(o+=`M${l.toFixed(1)} ${c.toFixed(1)}${r}`)}return ot("path",{d:o,class:`w-dots w-dots-${i}`,"stroke-width":i==="believed"?2.2*e:.7*e})}function $i(i,t,e,n=null){let s=i.plan.surface.rings.map(T=>ve(T)).filter(T=>T.length>=6),{goal:r}=i.plan,[o,a,l,c]=[1/0,1/0,-1/0,-1/0],h=(T,R)=>{[o,l]=[Math.min(o,T),Math.max(l,T)],[a,c]=[Math.min(a,R),Math.max(c,R)]};for(let T of s)for(let R=0;R<T.length;R+=2)h(T[R],T[R+1]);if(r?.kind==="collected"){let[[T,R],y]=[r.place,r.radius];h(T-y,R-y),h(T+y,R+y)}let u=s.length?.15*Math.max(l-o,c-a):1/0,[d,f,p,x]=[o-u,a-u,l+u,c+u];for(let{places:T}of t)for(let R=0;R+1<T.length;R+=2){let[y,E]=[T[R],T[R+1]];(!s.length||y>d&&y<p&&E>f&&E<x)&&h(y,E)}l>o||([o,a,l,c]=[0,0,1,1]);let m=.03*Math.max(l-o,c-a),g=[o-m,-c-m,l-o+2*m,c-a+2*m].map(T=>(1e3*T).toFixed(1)),v=Math.max(1,...t.map(({places:T})=>T.length/2)),S=7*Math.max(l-o,c-a)*Math.min(1,Math.max(.6,Math.sqrt(160/v))),b=s.map(T=>`M${Array.from({length:T.length/2},(R,y)=>`${(1e3*T[2*y]).toFixed(1)} ${(-1e3*T[2*y+1]).toFixed(1)}`).join("L")}Z`).join("");return ot("svg",{viewBox:g.join(" "),class:"w-picture",role:"img","aria-label":e},ot("path",{d:b,class:"w-ground","fill-rule":"evenodd","stroke-width":.005*1e3*Math.max(l-o,c-a)}),n&&ot("clipPath",{id:n.id},ot("path",{d:b,"clip-rule":"evenodd"})),n?.map,r?.kind==="collected"&&ot("circle",{cx:1e3*r.place[0],cy:-1e3*r.place[1],r:1e3*r.radius,class:"w-goal","stroke-width":.004*1e3*Math.max(l-o,c-a)}),...t.map(T=>bE(T,S)))}function Za(i){let t=ys(i),e=n=>{let s=t.filter(r=>r.degree===n);return s.length>0&&_("li",{"data-degree":n,style:`flex-grow:${s.length}`},_("span",{},Ys[n]),_("ul",{},...s.map(({label:r,colour:o})=>_("li",{},_("i",{"aria-hidden":"true",style:`background:var(--${o})`}),r))))};return _("div",{class:"w-scale"},_("ul",{"aria-label":`Scale in ${i.unit}`},...Object.keys(Ys).map(e)),_("p",{},`${i.unit}; allowed: ${px(i)}${i.unit==="passes"?", counted in whole passes":`, target ${i.target} ${i.unit}`}`))}function _E(i,t){let e=Va(i,t);return Object.keys(Ys).map(n=>`${Ct(Ha(e,n),1)} ${Ys[n]}`).join(", ")}function hu(i,t){let e=ys(i),n=e.map(()=>""),s=ve(i.places),[r,o]=i.cell.map(h=>1e3*h),[a,l]=[Ga*r,Ga*o],c=t.length;for(let h=0;h<c;){let u=vs(e,i,t[h]),[d,f]=[1e3*s[2*h],-1e3*s[2*h+1]],p=1,x=m=>h+m<c&&Math.abs(-1e3*s[2*(h+m)+1]-f)<.1*o&&Math.abs(1e3*s[2*(h+m)]-d-m*r)<.1*r;for(;x(p)&&vs(e,i,t[h+p])===u;)p++;n[u]+=`M${(d-a).toFixed(1)} ${(f-l).toFixed(1)}H${(d+(p-1)*r+a).toFixed(1)}V${(f+l).toFixed(1)}H${(d-a).toFixed(1)}z`,h+=p}return e.map(({colour:h},u)=>ot("path",{d:n[u],style:`fill:var(--${h})`}))}function Ya(i,t,e){let n=t.plan.treatment;if(!n||!e)return null;let s=ji(),r=`${i}: ${_i(t)} per place; ${_E(n,e)} of ${e.length} places`,o=ot("g",{"clip-path":`url(#${s})`,class:"w-map"},...hu(n,e));return _("figure",{},$i(t,[],r,{id:s,map:o}),_("figcaption",{},i))}function Rx({rounds:i},t){let e=i[0],n=i.at(-1),s=i.findLast(h=>h.interpreted)??null,r=e.plan.surface.shape?", surface unrolled":"",o=n.plan.treatment;if(!o){let h=`This recording has no ${_i(n)} per place.`;return[_("figure",{class:"w-wide"},$i(n,[],h),_("figcaption",{},h))]}let a=[Ya("Before",e,e.treated?.first??null),Ya(n.number===1?"Predicted":`Predicted for round ${n.number}`,n,n.treated?.last??null),t??(s&&Ya(`Estimated after ${s.number} ${s.number===1?"round":"rounds"}: mean of the belief`,s,vn(s.plan.treatment,s.interpreted?.treated)))].filter(h=>h!==null),l=_i(n),c=`${cl(l)} per place${r}`;return[_("p",{class:"w-wide w-quiet"},c),...a,Za(o)]}var Ks=5e-4,gp=700,xp=({plan:i},t)=>i.without?.find(e=>e.stroke===t)??null,uu=i=>i.plan.predicted??i.growthAt(1/0)??NaN;function Cx(i){let{phases:t,growth:e,strokes:n}=i.plan;if(!e.length)return[];let s=0,r=i.growthAt(0);return t.filter(({stroke:o})=>typeof o=="number"&&n[o]).map(({start:o,end:a,stroke:l})=>{let c=i.growthAt(a),h=xp(i,l),u={stroke:l,gain:c-r,marginal:h&&uu(i)-h.performance,way:wE(ve(n[l]??[])),start:o,time:a-s};return[s,r]=[a,c],u})}var wE=i=>{let t=0;for(let e=2;e+1<i.length;e+=2)t+=Math.hypot(i[e]-i[e-2],i[e+1]-i[e-1]);return t},Px=(i,t,e,n)=>i===0?`as many ${e} ${n}`:`${Math.abs(i)} ${i>0?"more":"fewer"} of ${t} ${e} ${n}`;function ME({plan:i,particles:t},e){let{goal:n,considered:s}=i,r=d=>{let f=0;for(let p=0;p+1<d.length;p+=2)n?.kind==="collected"&&Math.hypot(d[p]-n.place[0],d[p+1]-n.place[1])<=n.radius||f++;return f},o=t.places(0).length/2,a=r(ve(e.particles))-r(t.at(1/0)),l=n?.kind==="collected"?"stay outside the goal area":"stay on the surface",c=i.lost??s?.find(({chosen:d})=>d)?.lost??null,h=e.lost-(c??NaN),u=c===null?`${Ct(e.lost,1)} in all is lost`:Math.abs(h)<Ks?"nothing more is lost":`${Ct(Math.abs(h),1)} ${h>0?"more":"less"} is lost`;return o<gp?`${Px(a,o,"particles",l)}, and ${u}`:u}function SE({plan:{treatment:i},treated:t},e){let n=vn(i,e.treated);if(!i||!t||!n)return null;let s=ys(i),r=(o,a)=>o.filter(l=>s[vs(s,i,l)].degree===a).length;return["little","much"].map(o=>Px(r(n,o)-r(t.last,o),n.length,"places",`get ${Ys[o]}`)).join(", ")}function Ix(i,{stroke:t,way:e,time:n}){let s=xp(i,t),r=`The stroke takes ${Gt(n,1)} s with the way to it, and ${Gt(e,2)} m in contact.`,o=i.plan.headings?.[t];if(!s)return[r,...o?[o]:[]];let a=uu(i),l=Math.abs(a-s.performance)<Ks?`${Ct(a,1)} as with it`:`${Ct(s.performance,1)} instead of ${Ct(a,1)}`,c=i.plan.treatment?SE(i,s):ME(i,s);return[`Predicted without stroke ${t+1}: ${l}${c?`; ${c}`:""}.`,r,...o?[o]:[]]}function TE(i,t,e,n){let{width:s,height:r}=i.viewBox.baseVal,o=Math.max(s,r)/100,a=d=>Array.from({length:d.length/2},(f,p)=>`${p?"L":"M"}${(1e3*d[2*p]).toFixed(1)} ${(-1e3*d[2*p+1]).toFixed(1)}`).join(""),l=t.plan.strokes.map(d=>ve(d)),c=l.filter((d,f)=>f!==e).map(a).join(""),h=n?l[e]:null,u=[ot("path",{d:c,class:"w-line","stroke-width":.6*o})];if(h&&h.length>=4){let[d,f,p,x]=h.slice(-4),m=Math.atan2(f-x,p-d)*180/Math.PI,g=ot("path",{d:`M${3*o} 0L${-2*o} ${2.6*o}V${-2.6*o}z`,class:"w-line-tip",transform:`translate(${1e3*p} ${-1e3*x}) rotate(${m})`});u.push(...["w-line w-casing","w-line w-line-chosen"].map((v,S)=>ot("path",{d:a(h),class:v,"stroke-width":(S?1.6:3)*o})),g)}i.insertBefore(ot("g",{},...u),i.querySelector(".w-dots"))}function Lx(i,t){let e=xp(i,t);if(!e)return[];let{treatment:n}=i.plan,s=(o,a)=>{let l=a?i.treated?.last??null:vn(n,e.treated),c=a?i.particles.at(1/0):ve(e.particles),h=`${o}, at the end: the ${i.plan.surface.shape?"unrolled surface":"surface from above"} with ${c.length/2} particles`,u=n?Ya(o,i,l):_("figure",{},$i(i,[{mark:"believed",places:c}],h),_("figcaption",{},o)),d=u?.querySelector("svg.w-picture");return d&&TE(d,i,t,a),u},r=[s(`Predicted with stroke ${t+1}`,!0),s("Predicted without it",!1)].filter(o=>o!==null);return[_("div",{class:"w-pair"},...r),...n?[Za(n)]:[]]}var EE=.9;function du(i){let{plan:{treatment:t},interpreted:e,truth:n}=i;return bn(i)?!!(vn(t,e?.treated)&&vn(t,n?.treated)):!!(e&&n?.particles)}function AE(i){let t=i.filter(r=>r>0).sort((r,o)=>o-r),e=EE*t.reduce((r,o)=>r+o,0),n=0;return t.findIndex(r=>(n+=r)>=e-1e-9)+1}function RE(i,{cell:t,places:e}){let n=new Map,s=(r,o)=>Math.round((r-(e[o]??0))/(er*t));for(let r=0;r+1<i.length;r+=2){let o=`${s(i[r],0)} ${s(i[r+1],1)}`;n.set(o,(n.get(o)??0)+1)}return[...n.values()]}function Dx(i,[t,e],n){let s=ve(i);return s.filter((r,o)=>o%2===0&&Math.hypot(r-t,s[o+1]-e)<=n).length}function yp(i,t,e){let n=Math.abs(Math.round(t)-e);return[i,String(Math.round(t)),String(e),i.endsWith("(sample)")?"":`${n} ${n===1?"particle":"particles"}`]}function CE({plan:{goal:i},interpreted:t,truth:e}){let{particles:n,density:s}=t,r=e.particles,o=s?"":" (sample)",a=s?s.remaining??s.expected.reduce((d,f)=>d+f,0):n.length/2,l=e.remaining??r.length/2,c=r.length/2!==l||e.remaining===void 0&&r.length/2>=gp,h=[];if(i?.kind==="collected"&&!c&&(!s||s.goal!==void 0)){let d=s?.goal??Dx(n,i.place,i.radius),f=Dx(r,i.place,i.radius);h.push(yp(`In the goal area${o}`,d,f),yp(`Elsewhere on the surface${o}`,Math.max(0,a-d),l-f))}else(e.remaining!==void 0||!c)&&h.push(yp(`Left on the surface${o}`,a,l));let u=d=>`${Math.round(AE(d)*s.cell**2*1e4)} cm\xB2`;return s&&!c&&a>0&&l>0&&h.push(["Area that holds 90\u202F% of the dirt",u(s.expected),u(RE(r,s)),""]),h}function PE(i){let{plan:{treatment:t},interpreted:e,truth:n}=i,s=t,r=[vn(s,e.treated),vn(s,n.treated)],{length:o}=r[0],[a,l]=[Va(s,r[0]),Va(s,r[1])],c=r.map(d=>d.reduce((f,p)=>f+p,0)/Math.max(1,o)),h=d=>s.unit==="passes"?Gt(d,2):`${Gt(d,1)} ${s.unit}`,u=a.filter((d,f)=>d!==l[f]).length;return[[`Mean ${_i(i)}`,h(c[0]),h(c[1]),h(Math.abs(c[0]-c[1]))],["Places whose mean is in the band",Ct(Ha(a,"allowed"),1),Ct(Ha(l,"allowed"),1),`${u} of ${o} places`]]}function vp(i){let{mean:t,low:e,high:n}=i.interpreted.estimate,s=i.truth.performance??null,r=bn(i)?PE(i):CE(i);if(s===null)return r;let o=s>=e&&s<=n,a=`${Gt(Math.abs(Math.round(1e3*t)-Math.round(1e3*s))/10,1)} points, ${o?"inside":"outside"} the interval`;return[...r,["Performance",Ct(t,1),Ct(s,1),a]]}var IE={play:"M4 2.5v11l9.5-5.5z",pause:"M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z",before:"M3 3h2v10H3zM13 3v10L6 8z",after:"M11 3h2v10h-2zM3 3v10l7-5z"},bp=i=>ot("svg",{viewBox:"0 0 16 16",width:14,height:14,"aria-hidden":"true",fill:"currentColor"},ot("path",{d:IE[i]})),LE={believed:()=>ot("circle",{cx:8,cy:8,r:3.2,fill:"var(--believed)"}),estimated:()=>ot("circle",{cx:8,cy:8,r:4.6,fill:"none",stroke:"var(--estimated)","stroke-width":2.4}),actual:()=>ot("path",{d:"M4 4l8 8M12 4l-8 8",fill:"none",stroke:"var(--actual)","stroke-width":2.6}),seen:()=>ot("rect",{x:3,y:3,width:10,height:10,fill:"none",stroke:"var(--seen)","stroke-width":1.8}),map:()=>ot("g",{},...["little-3","allowed-2","much-1"].map((i,t)=>ot("rect",{x:1+5*t,y:3,width:5,height:10,fill:`var(--${i})`}))),path:()=>ot("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--contact)","stroke-width":2.4}),ribbon:()=>ot("g",{class:"w-forces"},...io.map(({colour:i},t)=>ot("rect",{x:1+5*t,y:7-2*t,width:5,height:2+4*t,fill:`var(--${i})`}))),strokes:()=>ot("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--stroke)","stroke-width":2}),rejected:()=>ot("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--rejected)","stroke-width":1.2}),bases:()=>ot("path",{d:"M14.5 8L9 11.5A4.5 4.5 0 1 1 9 4.5z",fill:"var(--band-6)",stroke:"var(--quiet)","stroke-width":1.2}),force:()=>ot("path",{d:"M8 15V6M8 1l4 6H4z",fill:"var(--force)",stroke:"var(--force)","stroke-width":2}),events:()=>ot("circle",{cx:8,cy:8,r:4.5,fill:"var(--collision)",stroke:"var(--ink)","stroke-width":1.2}),found:()=>ot("path",{d:"M2 12l3-8h9l-3 8z",fill:"var(--found)","fill-opacity":.3,stroke:"var(--found)","stroke-width":2}),actualSurface:()=>ot("path",{d:"M2 12l3-8h9l-3 8z",fill:"none",stroke:"var(--actual)","stroke-width":1.6,"stroke-dasharray":"3 2"}),collision:()=>ot("path",{d:"M5 2h6l3 6-3 6H5L2 8zM5 2l6 12M11 2L5 14",fill:"none",stroke:"var(--quiet)","stroke-width":1}),"by-touch":()=>ot("path",{d:"M8 1v14M5 1h6M5 15h6",fill:"none",stroke:"var(--by-touch)","stroke-width":1.6}),interval:()=>ot("path",{d:"M8 1v14M4 1h8M4 15h8",fill:"none",stroke:"var(--estimated)","stroke-width":2.2}),target:()=>ot("path",{d:"M0 8h16",fill:"none",stroke:"var(--target)","stroke-width":2,"stroke-dasharray":"4 3"}),goal:()=>ot("circle",{cx:8,cy:8,r:5.5,fill:"var(--goal)","fill-opacity":.35,stroke:"var(--goal-line)","stroke-width":1.6})},ao=i=>ot("svg",{viewBox:"0 0 16 16",width:15,height:15,"aria-hidden":"true"},LE[i]?.()),Nx=(i,t)=>ot("svg",{viewBox:"0 0 16 16",width:15,height:15,"aria-hidden":"true"},ot("path",{d:`M8 1l7 7-7 7-7-7z${t?"M8 5l3 3-3 3-3-3z":""}`,"fill-rule":"evenodd",fill:i,stroke:"#000","stroke-width":1.4}));var _p=[1,3,10],kx=[.15,.85],DE=.03,Ox=i=>Math.max(0,_p.findLastIndex(t=>i>=t));function NE({cell:i,places:t,expected:e}){let n=ve(t),s=_p.map(()=>"");return e.forEach((r,o)=>{if(!(r>0))return;let a=500*i*Math.sqrt(Math.min(1,r)),[l,c]=[1e3*n[2*o],-1e3*n[2*o+1]];s[Ox(r)]+=`M${(l-a).toFixed(1)} ${(c-a).toFixed(1)}h${(2*a).toFixed(1)}v${(2*a).toFixed(1)}h${(-2*a).toFixed(1)}z`}),s.map((r,o)=>ot("path",{d:r,class:`w-density-${o+1}`}))}function Fx({cell:i}){let t=e=>{let n=14*Math.sqrt(Math.min(1,e));return ot("svg",{viewBox:"0 0 14 14",width:14,height:14,"aria-hidden":"true"},ot("rect",{x:7-n/2,y:7-n/2,width:n,height:n,class:`w-density-${Ox(e)+1}`}))};return _("li",{},`estimate: expected particles per ${Math.round(1e3*i)} mm cell:`,...[.1,.5,..._p].flatMap((e,n,s)=>[t(e),`${n===s.length-1?"\u2265\u202F":""}${e}`]))}var fu=class{element=_("figure",{class:"w-seam"});table=_("div",{class:"w-compared"});share=null;chosen=null;rounds=[];show(t){this.rounds=t.filter(du);let e=this.rounds.find(({number:n})=>n===this.chosen)??this.rounds.at(-1);return this.table.replaceChildren(this.makeTable(e)),this.element.replaceChildren(...this.draw(e)),this.element}draw(t){let{plan:{surface:{shape:e}},interpreted:n,truth:s,number:r}=t,o=bn(t)?t.plan.treatment:null,[a,l,c]=[ji(),ji(),ji()],h=(P,...k)=>ot("g",{"clip-path":`url(#${P})`,class:"w-map"},...k),u=o?null:n.density??null,d=o?{id:a,map:ot("g",{"clip-path":`url(#${a})`},h(l,...hu(o,vn(o,n.treated))),h(c,...hu(o,vn(o,s.treated))))}:null,f=o?[]:[...u?[]:[{mark:"estimated",places:ve(n.particles)}],{mark:"actual",places:ve(s.particles)}],p=vp(t).map(([P,k,O])=>`${P}: ${k} estimated, ${O} true.`),x=`The ${e?"unrolled surface":"surface from above"} at the end of round ${r}: estimated left of the seam, true right of it. ${p.join(" ")}`,m=$i(t,f,x,d);u&&m.querySelector(".w-dots")?.before(h(l,...NE(u))),m.querySelector(".w-dots-estimated")?.setAttribute("clip-path",`url(#${l})`),m.querySelector(".w-dots-actual")?.setAttribute("clip-path",`url(#${c})`);let[g,v,S,b]=m.getAttribute("viewBox").split(" ").map(Number);this.share??=o?.5:kE(ve(s.particles),g/1e3,S/1e3);let[T,R]=[l,c].map(P=>ot("clipPath",{id:P},ot("rect",{y:v,height:b}))),y=ot("path",{class:"w-seam-line","vector-effect":"non-scaling-stroke"});m.append(T,R,y);let E=_("input",{type:"range",min:0,max:1,step:.01,"aria-label":"Seam between estimate and truth",input:()=>D(Number(E.value))}),D=P=>{this.share=P;let k=g+P*S;for(let[O,B,I]of[[T,g,k],[R,k,g+S]])O.firstElementChild.setAttribute("x",String(B)),O.firstElementChild.setAttribute("width",String(I-B));y.setAttribute("d",`M${k} ${v}v${b}`),E.setAttribute("aria-valuetext",`${Ct(P)} of the width shows the estimate, the rest the truth`)};return this.element.style.setProperty("--ratio",(S/b).toFixed(4)),E.value=String(this.share),D(Number(E.value)),[_("div",{class:"w-seam-picture"},m,E),_("figcaption",{},_("span",{},`\u25C2 Estimated${o?" mean":""}`),_("span",{},"True \u25B8"),this.makeChoice(t))]}makeChoice(t){let e="End of round";return this.rounds.length===1?_("p",{class:"w-rounds"},`${e} ${t.number}`):_("div",{class:"w-rounds",role:"group","aria-label":e},e,...this.rounds.map(({number:n})=>_("button",{type:"button",class:"w-button","aria-pressed":String(n===t.number),click:()=>{this.chosen=n,this.show(this.rounds),this.element.querySelector("[aria-pressed=true]")?.focus()}},String(n))))}makeTable(t){return _("table",{},_("thead",{},_("tr",{},...[`End of round ${t.number}`,"Estimated","True","Off by"].map(e=>_("th",{scope:"col"},e)))),_("tbody",{},...vp(t).map(([e,...n])=>_("tr",{},_("th",{scope:"row"},e),...n.map(s=>_("td",{},s))))))}};function kE(i,t,e){let n=Array.from({length:i.length/2},(r,o)=>i[2*o]).sort((r,o)=>r-o),s=n[n.length>>1];return s===void 0?.5:Math.min(kx[1],Math.max(kx[0],(s-t)/e-DE))}var Ux=3,Bx=i=>`${i>0?"+":""}${Gt(100*i,1)}`,Gx=i=>i.length>1?`${i.slice(0,-1).join(", ")} and ${i.at(-1)}`:String(i[0]);function OE(i,t){let e=i.filter(r=>r.marginal!==null);if(e.length<2)return[];let n=e.reduce((r,o)=>o.marginal>r.marginal?o:r),s=e.filter(({marginal:r})=>r<Ks).map(({stroke:r})=>r+1);return[...n.marginal>=Ks?[`Stroke ${n.stroke+1} is predicted to matter most: without it, the plan reaches ${Ct(t-n.marginal,1)} instead of ${Ct(t,1)}.`]:[],...s.length?[`Without stroke ${Gx(s).replace(" and "," or ")} alone, the plan is predicted to reach ${s.some(r=>e.find(o=>o.stroke+1===r).marginal<=-Ks)?"as much or more":"as much"}. It may still help if dirt or tool differ from the belief.`]:[]]}function FE(i){let t=new Map;i.forEach((s,r)=>t.set(s,[...t.get(s)??[],r+1]));let n=[...t].sort(([,s],[,r])=>r.length-s.length).slice(0,Ux).map(([s,r])=>`${t.size===1&&i.length>1?"All strokes":r.length>1?`Strokes ${Gx(r)}`:`Stroke ${r[0]}`}: ${s}`);return t.size>Ux?[...n,"Choose another stroke in the table to see how the tool is turned in it."]:n}var zx=(i,t)=>_("div",{class:"w-choice",tabindex:0,role:"group","aria-label":i},t),pu=class{constructor(t,e){this.seek=t;this.choose=e}seek;choose;element=_("div");round=null;stroke=null;rejected=null;kept=null;show(t,e){if(t&&t===this.round)return;(this.stroke!==null||this.rejected)&&this.choose(null),[this.round,this.stroke,this.rejected,this.kept]=[t,null,null,null];let n=t?Cx(t):[],{without:s,predicted:r,another:o=s?.length?null:void 0,...a}=t?.plan??{},[l,c,h]=[a.why??[],a.considered??[],a.headings??[]],u=tr(OE(n,t?uu(t):NaN));t&&o&&u.append(_("li",{},...this.describeAnother(t,o))),u.append(...tr([...o===null&&(r??0)<1-Ks?["A repetition of a stroke at the end is predicted to gain nothing."]:[],...FE(h),...l]).children),this.element.replaceChildren(u.childElementCount?u:_("p",{class:"w-quiet"},e),...c.length?[this.makeCandidates(c)]:[],...t&&n.length?[this.makeStrokes(t,n)]:[])}publish(){this.round&&this.choose({round:this.round,stroke:this.stroke,rejected:this.rejected})}preview(t){let e=s=>()=>{this.rejected!==s&&(this.rejected=s,this.publish())},n=()=>e(this.kept)();return t?{pointerenter:e(t),pointerleave:n,focusin:e(t),focusout:n}:{}}makeKeeper(t,e){return _("button",{type:"button",class:"w-link","aria-pressed":"false",title:"Show its strokes in the scene",click:({currentTarget:n})=>{this.kept=this.kept===e?null:e;for(let s of this.element.querySelectorAll(".w-link[aria-pressed]"))s.setAttribute("aria-pressed",String(s===n&&this.kept!==null));this.rejected=this.kept,this.publish()}},t)}describeAnother({plan:{strokes:t}},{gain:e,line:n,way:s}){let r=t.findIndex(l=>String(l)===String(n)),o={name:r<0?"One more stroke":`Repetition of stroke ${r+1}`,lines:[n]},a=r<0?"One more stroke":`Stroke ${r+1} once more at the end`;return[_("span",this.preview(o),this.makeKeeper(a,o)),` is predicted to gain ${Gt(100*e,1)} points with ${Gt(s,2)} m in contact.`]}makeCandidates(t){let e=["Strategy","Score","Share","Lost","Contact","Time"],n=[...t].sort((s,r)=>(r.score??-1/0)-(s.score??-1/0)).map(s=>{let{strategy:r,chosen:o,score:a,predicted:l,lost:c,strokes:h,in_contact:u,duration:d,error:f,lines:p}=s,x=!o&&p?.length?{name:`Rejected plan: ${r}, ${p.length} strokes`,lines:p}:null,m=[Xe(a,g=>Gt(g,2)),Xe(l,Ct),Xe(c,Ct),Xe(u,g=>`${Gt(g,2)} m`),Xe(d,g=>`${Gt(g,0)} s`)];return _("tr",{"data-chosen":o,title:typeof h=="number"&&`${h} strokes`,...this.preview(x)},_("th",{scope:"row"},o&&"\u2713 ",x?this.makeKeeper(r,x):r,o&&_("span",{class:"w-hidden"}," (chosen)")),...f?[_("td",{class:"w-none-found",colspan:e.length-1},`no plan: ${f}`)]:m.map(g=>_("td",{},g)))});return zx("Candidate plans",bo(e,n,"Share: predicted performance. Lost: predicted share of lost dirt. Score: predicted share of the dirt that reaches the goal, minus three times the lost share, minus what heaps near an edge put at risk, minus costs of remaining dirt by its distance, of path length and time."))}makeStrokes(t,e){let n=e.some(({marginal:l})=>l!==null),s=["Stroke","In turn",...n?["Marginal"]:[],"Contact","Time"],r=_("td",{colspan:s.length,class:"w-stroke"}),o=_("tr",{},r),a=e.map(l=>{let{stroke:c,gain:h,marginal:u,way:d,start:f,time:p}=l,x=_("button",{type:"button",class:"w-link","aria-expanded":"false","aria-label":`Stroke ${c+1}`,click:()=>{let g=this.stroke===c;this.stroke=g?null:c;for(let v of a)v.querySelector("button").setAttribute("aria-expanded",String(v===m&&!g));o.remove(),g||(r.replaceChildren(...Lx(t,c),tr(Ix(t,l))),m.after(o),o.scrollIntoView({block:"nearest"}),this.seek(t.start+f)),this.publish()}},String(c+1)),m=_("tr",{},_("th",{scope:"row"},x),...[Bx(h),...n?[Xe(u,Bx)]:[],`${Gt(d,2)} m`,`${Gt(p,1)} s`].map(g=>_("td",{},g)));return m});return zx("Strokes",bo(s,a,`Predicted gain of each stroke in performance, in points. In turn: rise while it is wiped; a stroke without a rise may prepare a later one.${n?" Marginal: the whole plan minus the plan without it.":""} Contact: its way in contact. Time: with the way to it.`))}};var ja=(i,t,...e)=>_("details",{class:"w-section",open:t},_("summary",{},_("h2",{},i)),...e),Xi=({mean:i,low:t,high:e},n=Ct(i))=>`${n} (90\u202F%: ${Ct(t)} to ${Ct(e)})`,Vx=["performance unknown","undecided by touch","cannot be told","unknowable by touch"],Mp=(i,t)=>i?"met":Vx.includes(t??"")?"unknown":"unmet";function co({rounds:i,ended:t,live:e}){let n=r=>i.length>0&&i.every(({plan:o})=>o.kind===r);return e?{state:"live",text:"running"}:n("planned")?{state:"planned",text:"planned only"}:n("logged")?{state:"logged",text:"from the log"}:t?{state:Mp(t.met,Vx.includes(t.badge??"")?t.badge:t.verdict),text:t.badge??t.verdict??(t.met?"goal met":"stopped")}:{state:"broken",text:"ended early"}}function xu({rounds:i,ended:t},{number:e,plan:{kind:n},interpreted:s,over:r}){return n==="planned"?"planned only":n==="logged"?"from the log":s?(i.findLast(a=>a.interpreted)?.number===e?t?.badge:null)??s.verdict:r?"no result":"running"}function Sp(i,{round:t,time:e,phase:n}){if(e>=t.length-1e-6&&t.interpreted)return xu(i,t);let s=t.plan.phases[n],r=typeof s?.stroke=="number"?` \xB7 stroke ${s.stroke+1} of ${t.plan.strokes.length}`:"";return`${s?hl(s.name):"starting"}${r}`}var lo=(i,t)=>[_("dt",{},i),_("dd",{},t)],mu="The episode was kept without a recording: the page shows its telemetry and its events.",wp=300,gu=class{constructor(t,e,n){this.recording=t;this.clock=e;this.why=new pu(l=>e.seek(l),n);let{contact:s,force:r,height:o,performance:a}=this.live;this.element=_("aside",{class:"w-words","aria-label":"Details of the run",tabindex:0},_("div",{class:"w-now"},this.headline,this.below,_("dl",{class:"w-values"},_("div",{},_("dt",{},"Contact"),s),_("div",{},_("dt",{},"Force"),r),_("div",{},_("dt",{},"Height"),o),_("div",{},this.performanceName,a))),this.complaint,ja("Why this plan",!0,this.why.element),ja("Result",!0,this.after),ja("Events",!0,this.events),ja("Numbers",!0,this.numbers),ja("Log",!1,this.logCount,this.log))}recording;clock;element;headline=_("p",{class:"w-headline"});below=_("p",{class:"w-quiet"});live={contact:_("dd"),force:_("dd"),height:_("dd"),performance:_("dd")};performanceName=_("dt",{},"Predicted");why;after=_("div");events=_("div");numbers=_("div");log=_("ol",{class:"w-log"});logCount=_("span",{class:"w-quiet"});complaint=_("p",{class:"w-complaint",hidden:!0});key="";whole="";shownEvents=[];show(){let{recording:t,clock:e}=this,n=t.at(e.time);this.showNow(n);let s=n?.round,r=[s?.number,s?.start,t.rounds.length,!!s?.interpreted,!!s?.truth,t.live,t.ended?.badge].join();r!==this.key&&(this.key=r,this.showRound(s??null));let{stages:o,happenings:a,head:l,ended:c,broken:h,unknown:u}=t,d=[o.length,a.length,!!l,!!c,h,u].join();d!==this.whole&&(this.whole=d,this.showRun());for(let{element:f,start:p,end:x}of this.shownEvents)f.toggleAttribute("data-now",e.time>=p-.05&&e.time<=x+.05)}showNow(t){let{recording:e,clock:n}=this,s=e.live&&(n.following||!t)?e.stages.at(-1):void 0;if(!t){zt(this.headline,s?.words??(e.live?e.head?"No round has begun.":"The recording is empty so far.":"The recording has no rounds.")),zt(this.below,"");for(let f of Object.values(this.live))zt(f,An);return}let{round:r,time:o,normal:a,height:l,performance:c,contact:h}=t,u=e.rounds.length;zt(this.headline,cl(s&&s.stage!=="executing"?s.words:Sp(e,t))),zt(this.below,`Round ${r.number} of ${u}${r.plan.kind==="planned"?" (planned only)":""} \xB7 ${oe(o)} of ${oe(r.length)}`),zt(this.live.contact,h==="contact"?"yes":h==="pushed"?"pushed":"none"),zt(this.live.force,Xe(a,f=>`${Gt(f,1)} N`)),zt(this.live.height,Xe(l,f=>`${Gt(1e3*f,1)} mm`));let d=e.resultAt(n.time)?.interpreted;zt(this.performanceName,d?"Estimated":"Predicted"),zt(this.live.performance,d?Ct(d.estimate.mean):Xe(c,Ct))}showRound(t){if(this.why.show(t,t?t.plan.kind==="logged"?mu:"The recording states no reasons for this plan.":"No plan yet."),!t?.interpreted){let s=t?t.plan.kind==="planned"?"This plan was not executed.":t.plan.kind==="logged"?mu:this.recording.live?"The round is not finished.":"The round has no result because the run ended early.":"No round yet.";this.after.replaceChildren(_("p",{class:"w-quiet"},s));return}let{interpreted:e,truth:n}=t;this.after.replaceChildren(_("p",{class:"w-quiet"},`Round ${t.number}, known from ${oe(t.end)} on.`),_("p",{},_("strong",{},xu(this.recording,t)),e.ending?` \xB7 ${e.ending}`:""),_("dl",{class:"w-facts"},...lo("Predicted",Xe(t.plan.predicted,Ct)),...lo("Estimated",Xi(e.estimate)),...lo("From touch only",Xi(e.by_touch)),...typeof n?.performance=="number"?lo("True",Ct(n.performance)):[],...e.found?lo("Surface","not at its believed pose"):[]),tr(e.words))}showRun(){let{recording:t,clock:e}=this,n=t.happenings.slice(0,wp);this.shownEvents=[],this.events.replaceChildren(n.length?_("ul",{class:"w-events"},...n.map(({start:o,end:a,kind:l,words:c,source:h})=>{let u=_("button",{type:"button","data-source":h,click:()=>e.seek(o)},_("span",{class:"w-when"},oe(o)),_("span",{},_("strong",{},l),` ${c}`));return this.shownEvents.push({element:u,start:o,end:a}),_("li",{},u)}),t.happenings.length>wp&&_("li",{class:"w-quiet"},`and ${t.happenings.length-wp} more`)):_("p",{class:"w-quiet"},"None.")),this.showNumbers(),this.log.replaceChildren(...t.stages.slice(-500).map(({round:o,stage:a,words:l})=>_("li",{},_("span",{class:"w-when"},`${o} ${a}`),` ${l}`))),zt(this.logCount,t.stages.length>500?`The list shows the last 500 of ${t.stages.length} entries.`:"");let{broken:s,unknown:r}=t;this.complaint.hidden=!s&&!r,zt(this.complaint,[s?`${s} ${s===1?"line":"lines"} of this recording could not be read.`:"",r?`${r} ${r===1?"piece":"pieces"} of unknown kind ${r===1?"was":"were"} skipped.`:""].join(" ").trim())}showNumbers(){let{head:t,ended:e,rounds:n}=this.recording;if(!t)return;let{task:s,robot:r}=t,o=[...s?[["Task",`${s.action} ${s.medium} with ${s.tool} on ${s.surface}`],["Strategy",s.strategy],["Target",Ct(s.target)],["Seed",String(s.seed)]]:[],...r?[["Robot",`${r.name}, ${r.variables.length} variables`]]:[],["Program",t.program],...t.begun?[["Started",t.begun]]:[],...e?.episode?[["Episode",e.episode]]:[]],a=new Set(o.map(([c])=>c)),l=new Map([[null,o]]);for(let c of e?.facts??[]){if(a.has(c[0]))continue;let h=n.length>1?UE(c,n[0].number):null;l.set(h,[...l.get(h)??[],[c[0],c[1]]])}this.numbers.replaceChildren(...[...l].flatMap(([c,h])=>[...l.size>1?[_("h3",{},c===null?`Whole run, ${n.length} rounds`:`Round ${c}`)]:[],_("dl",{class:"w-facts"},...h.flatMap(([u,d])=>lo(String(u),String(d))))]))}},UE=([i,t,e],n)=>e!==void 0?e:/ in \d+ rounds$/.test(t)||/^(Target performance|Tool held|Maximum path error|Minimum clearance|Distance in contact|Distance in total|Goal|Steps|Links|Joints held at their ready positions)$/.test(i)?null:n;var Tp={believed:"believed before",estimated:"estimated after",actual:"true after",seen:"observed",sample:"estimated after: a typical sample",interval:"90\u202F% interval","by-touch":"from touch only",target:"target",goal:"goal area"},Ka=i=>_("ul",{class:"w-legend"},...i.map(t=>_("li",{},ao(t==="sample"?"estimated":t),Tp[t]))),BE=6,zE=i=>i===null?"":` Predicted performance: ${Ct(i)}.`;function GE(i){let t=_("button",{type:"button",class:"w-button",click:()=>{(navigator.clipboard?navigator.clipboard.writeText(i):Promise.reject()).then(()=>zt(t,"Copied"),()=>zt(t,"Not copied"))}},"Copy");return _("div",{class:"w-command"},_("code",{},i),t)}var ho=class{constructor(t,e,n){this.recording=t;this.seek=e;this.element=_("header",{class:"w-story"},_("div",{class:"w-top"},this.title,this.badge,n),_("div",{class:"w-told"},this.pictures,this.texts,this.incidents)),this.stop=t.onChange(s=>{(!s||s.piece!=="samples")&&this.ask()}),this.show()}recording;seek;element;title=_("h1",{});badge=_("p",{class:"w-badge"});pictures=_("div",{class:"w-pictures"});texts=_("div",{class:"w-texts"});seam=new fu;comparison=_("div",{class:"w-comparison"});incidents=_("section",{class:"w-incidents","aria-label":"Incidents"});keys=new Map;stop;asked=0;destroy(){this.stop(),cancelAnimationFrame(this.asked)}ask(){this.asked||(this.asked=requestAnimationFrame(()=>{this.asked=0,this.show()}))}show(){let{head:t,ended:e,rounds:n,stages:s,live:r}=this.recording,o=n.findLast(p=>p.interpreted)??null;zt(this.title,t?.title||"Recording");let{state:a,text:l}=co(this.recording),[c,h]=[a==="planned",a==="logged"];this.badge.dataset.state=a,zt(this.badge,l);let u=e?.story,d=u?.happened??(r?s.at(-1)?.words??"The run is starting.":o?`The run ended early after round ${o.number}: ${o.interpreted.verdict}.`:c?`Planned, not executed.${zE(n.at(-1).plan.predicted)}`:h?mu:n.length?"The recording ends before the first round has a result.":"The recording has no rounds."),f=n.map(({number:p,interpreted:x,truth:m})=>[p,x?.estimate,x?.by_touch,m?.performance]);this.rebuild(this.texts,[t?.task,u,r,d,a,f],()=>[...this.makePart("Task",u?.asked??t?.task?.asked??""),...this.makePart(r?"Now":"Result",d),...this.makePart("Confidence",u?.sure??(o||c||h?"":"No round has a result yet."),this.drawBars()),this.comparison,...this.makePart("More certainty",u?.surer??""),...this.makePart("Next",u?.next?.words??"",u?.next?.command?GE(u.next.command):null)]),this.drawPictures(),this.showIncidents()}showIncidents(){let t=this.recording.rounds.flatMap(o=>(o.interpreted?.incidents??[]).map(a=>({round:o,incident:a}))),e=this.recording.rounds.some(o=>o.interpreted?.incidents),n=t.slice(0,BE),s=t.length-n.length;this.incidents.hidden=!e;let r=[s,n.map(({round:{number:o,start:a},incident:l})=>[o,a,l])];this.rebuild(this.incidents,r,()=>[_("h2",{},"What did not go as planned"),...t.length?[_("ul",{},...n.map(({round:o,incident:a})=>this.makeCard(o,a))),...s?[_("p",{class:"w-quiet"},`and ${s} more`)]:[]]:[_("p",{class:"w-quiet"},"Nothing unusual was detected.")]])}rebuild(t,e,n){let s=JSON.stringify(e);this.keys.get(t)!==s&&(this.keys.set(t,s),t.replaceChildren(...n()))}makeCard(t,{time:e,title:n,evidence:s,effect:r,advice:o}){let a=`Round ${t.number}${e===null?"":` \xB7 ${oe(t.start+e)}`}`;return _("li",{"data-round":t.number},_("button",{type:"button",class:"w-when",title:"Show this time",click:()=>this.seek(t.start+(e??0))},a),_("h3",{},n),...[s,r].filter(l=>l).map(l=>_("p",{},l)),o?_("p",{class:"w-advice"},o):null)}makePart(t,e,n=null){if(!e&&!n)return[];let s=[_("h2",{},t)];return e&&s.push(_("p",{},e)),n&&s.push(n),s}drawPictures(){let{rounds:t,observedBefore:e}=this.recording,n=t[0],s=t.findLast(o=>o.interpreted??o.truth)??null,r=t.map(({plan:o,interpreted:a,truth:l,observed:c})=>[o.round,o.predicted,o.duration,!!a,!!l,!!c]);this.rebuild(this.pictures,[r,!!e],()=>{let o=s&&du(s)?this.seam.show(t):null;return this.comparison.replaceChildren(...o?this.makePart("Ground truth","",this.seam.table):[]),this.pictures.toggleAttribute("data-maps",!!(n&&bn(n))),n?bn(n)?Rx(this.recording,o):this.makeDirtFigures(n,s,o):[]})}makeDirtFigures(t,e,n){let{observedBefore:s}=this.recording,r=t.plan.goal?.kind==="collected"?["goal"]:[],o=[{mark:"believed",places:t.particles.places(0)}];s&&o.push({mark:"seen",places:ve(s.detections)});let a=t.plan.surface.shape,l=(u,d,f)=>_("figure",{},$i(d,f,`${u}: the ${a?"unrolled surface":"surface from above"} with ${f.map(({places:p,mark:x})=>`${p.length/2} particles ${Tp[x]}`).join(", ")}`),_("figcaption",{},a?`${u}, surface unrolled`:u)),c=(...u)=>[...new Set(u.map(({mark:d})=>d)),...r];if(!e){if(t.plan.kind!=="planned")return[l("Believed before",t,o),Ka(c(...o))];let u=[{mark:"believed",places:t.particles.places(Math.max(0,t.particles.times.length-1))}];return[l("Before",t,o),this.drawArrow(),l("Predicted",t,u),Ka(c(...o,...u))]}if(n){let u=e.interpreted?.density,d=Ka([...c(...o),...u?[]:["sample"],"actual"]);return u&&d.append(Fx(u)),[l("Before",t,o),this.drawArrow(),n,d]}let h=[];return e.interpreted&&h.push({mark:"estimated",places:ve(e.interpreted.particles)}),e.truth?.particles&&h.push({mark:"actual",places:ve(e.truth.particles)}),e.observed&&h.push({mark:"seen",places:ve(e.observed.detections)}),[l("Before",t,o),this.drawArrow(),l(`After ${e.number} ${e.number===1?"round":"rounds"}`,e,h),Ka(c(...o,...h))]}drawArrow(){return ot("svg",{viewBox:"0 0 24 24",class:"w-arrow","aria-hidden":"true"},ot("path",{d:"M3 12h16M13 6l6 6-6 6"}))}drawBars(){let{rounds:t,head:e}=this.recording,n=t.filter(l=>l.interpreted).slice(-8);if(!n.length)return null;let s=e?.task?.target??null,r=n.map(({number:l,interpreted:c,truth:h})=>{let{estimate:u,by_touch:d}=c,f=h?.performance??null,p=v=>`${(1.5+97*Math.min(1,Math.max(0,v))).toFixed(2)}%`,x=(v,S)=>`${Math.max(.6,97*(Math.min(1,S)-Math.max(0,v))).toFixed(2)}%`,m=(v,S,b,T)=>ot("line",{x1:p(v),x2:p(v),y1:S,y2:b,...T}),g=`Round ${l}: estimated ${Ct(u.mean)}, 90 % interval ${Ct(u.low)} to ${Ct(u.high)}${f===null?"":`, true ${Ct(f)}`}`;return _("div",{class:"w-bar"},_("span",{},`Round ${l}`),ot("svg",{role:"img","aria-label":g},ot("rect",{x:p(0),y:8,width:"97%",height:10,rx:5,fill:"var(--lane)"}),ot("rect",{x:p(d.low),y:21.5,width:x(d.low,d.high),height:2,fill:"var(--by-touch)"}),ot("rect",{x:p(u.low),y:6,width:x(u.low,u.high),height:14,rx:4,fill:"var(--estimated)","fill-opacity":.35,stroke:"var(--estimated)","stroke-width":1.6}),m(u.mean,4,22,{stroke:"var(--estimated)","stroke-width":3}),s!==null&&m(s,0,26,{stroke:"var(--target)","stroke-width":2,"stroke-dasharray":"4 3"}),f!==null&&ot("svg",{x:p(f),y:13,overflow:"visible"},ot("path",{d:"M-5 -5L5 5M5 -5L-5 5",stroke:"var(--actual)","stroke-width":2.6,fill:"none"}))),_("b",{},Ct(u.mean)))}),o=n.some(({truth:l})=>typeof l?.performance=="number"),a=Ka(["interval","by-touch",...o?["actual"]:[],...s===null?[]:["target"]]);for(let l of a.children)l.textContent===Tp.actual&&(l.lastChild.textContent="true");return s!==null&&(a.lastElementChild.lastChild.textContent=`target ${Ct(s)}`),_("div",{class:"w-bars"},...r,a)}};var Wx=["video/webm;codecs=vp8","video/webm"],VE=5e6,HE=1500,WE=100,$E=3.1,XE=.05,yu=34,Hx=15;function qE(){return typeof MediaRecorder>"u"||!("captureStream"in HTMLCanvasElement.prototype)?"This browser cannot record video: it has no MediaRecorder for a canvas.":Wx.some(i=>MediaRecorder.isTypeSupported(i))?null:"This browser cannot record WebM video."}var Ep=class{constructor(t,e,n,s,r,o){this.stage=t;this.recording=e;this.clock=n;this.from=s;this.to=r;this.speed=o;let{clientWidth:a,clientHeight:l}=t.canvas,c=u=>2*Math.round(u*this.ratio/2);Object.assign(this.canvas,{width:c(a),height:c(l+2*yu)});let h=this.canvas.captureStream(0);this.track=h.getVideoTracks()[0],this.recorder=new MediaRecorder(h,{mimeType:Wx.find(u=>MediaRecorder.isTypeSupported(u)),videoBitsPerSecond:VE}),this.recorder.addEventListener("dataavailable",({data:u})=>this.chunks.push(u))}stage;recording;clock;from;to;speed;canvas=_("canvas");pen=this.canvas.getContext("2d");ratio=Math.min(2,devicePixelRatio||1);chunks=[];recorder;track;begun=0;isRunning=!1;start(t){this.recorder.addEventListener("start",()=>{this.begun=performance.now(),this.isRunning=!0,t()}),this.recorder.start(1e3),this.draw()}draw(){let{canvas:t,pen:e,clock:n,recording:s,ratio:r}=this,o=s.at(n.time),a=yu*r;e.fillStyle=gt("scene"),e.fillRect(0,0,t.width,t.height),e.drawImage(this.stage.canvas,0,a,t.width,t.height-2*a);let l=s.resultAt(n.time)?.interpreted,c=l?`Estimated ${Xi(l.estimate)}`:typeof o?.performance=="number"?`Predicted ${Ct(o.performance)}`:"",h=`${oe(n.time)} / ${oe(n.duration)}${this.speed===1?"":` \xB7 ${this.speed}\xD7`}`;this.write(0,s.head?.title||"Recording",h),this.write(t.height-a,o?`Round ${o.round.number} of ${s.rounds.length} \xB7 ${Sp(s,o)}`:"",c),this.track.requestFrame()}write(t,e,n){let{canvas:s,pen:r,ratio:o}=this,[a,l]=[12*o,t+(yu/2+.36*Hx)*o];r.fillStyle=gt("paper"),r.fillRect(0,t,s.width,yu*o),r.fillStyle=gt("ink"),r.font=`600 ${Hx*o}px system-ui, sans-serif`;let c=Math.min(r.measureText(n).width,s.width/2);r.fillText(n,s.width-a-c,l,c),r.fillText(e,a,l,s.width-c-3*a)}async finish(){let t=(performance.now()-this.begun)/1e3;this.pen.fillStyle=gt("paper");for(let e=performance.now()+HE;performance.now()<e;)await new Promise(n=>setTimeout(()=>requestAnimationFrame(n),WE)),this.pen.fillRect(0,0,1,1),this.track.requestFrame();return await this.stop(),{clip:new Blob(this.chunks,{type:"video/webm"}),took:t}}stop(){if(this.recorder.state==="inactive")return Promise.resolve();let t=new Promise(e=>this.recorder.addEventListener("stop",()=>{this.track.stop(),e()}));return this.recorder.stop(),t}},YE=5e-7;function $x(i,t,e){let n=qE(),s=null,r=0,o=_("select",{class:"w-select","aria-label":"Part of the run"}),a=_("button",{class:"w-button",type:"button",click:()=>f()}),l=_("button",{class:"w-button",type:"button",hidden:!0,click:()=>d("The recording was cancelled.")},"Cancel"),c=_("progress",{max:1,value:0,hidden:!0,"aria-label":"Progress of the recording"}),h=_("p",{role:"status"},n??"The clip shows the current view, with title, clock and result."),u=_("a",{class:"w-button",hidden:!0},"Save the clip");a.disabled=n!==null;let d=v=>{s?.stop(),s=null,i.onDrawn=null;for(let S of[l,c])S.hidden=!0;zt(h,v),e.playing&&e.pause(),g()},f=()=>{let v=t.rounds[Number(o.value)-1],[S,b]=v?[v.start,Math.min(v.end-(v===t.rounds.at(-1)?0:YE),e.end)]:[0,e.end];if(!(b>S))return d("Nothing to record: this part takes no time.");let T=Math.max(1,e.speed);e.pause(),e.setSpeed(T),e.seek(S);try{s=new Ep(i,t,e,S,b,T)}catch(y){return d(`The recording cannot start: ${y.message}`)}for(let y of[l,c])y.hidden=!1;u.hidden=!0,zt(h,`Recording ${oe(b-S,0)} at ${T}\xD7.`);let R=s;r=S,i.onDrawn=()=>{i.onDrawn=()=>R.draw(),R.start(()=>{s===R&&e.play()})},i.ask(),g()},p=async v=>{v.isRunning=!1,e.pause(),e.seek(v.to);let{clip:S,took:b}=await v.finish();if(s!==v)return;let T=(v.to-v.from)/v.speed,R=Math.abs(b-T)<=XE*T+.2;URL.revokeObjectURL(u.href),Object.assign(u,{href:URL.createObjectURL(S),hidden:!1,download:`${(t.head?.title||"recording").replace(/[^\p{L}\p{N}]+/gu,"-")}.webm`}),d(`${oe(b)} at ${v.speed}\xD7, ${(S.size/1e6).toFixed(1)} MB.${R?"":` The clip is not of this speed: it should take ${oe(T)}. This machine draws too slowly.`}`)},x=e.subscribe(()=>{if(!s?.isRunning)return;let{from:v,to:S,speed:b}=s,T=e.time-r;r=e.time,c.value=(e.time-v)/(S-v),e.time>=S-1e-6?p(s):(!e.playing||e.speed!==b||T<0||T>$E*b)&&d("The recording was cancelled, because the clock was changed.")}),m=()=>{document.hidden&&s&&d("The recording was cancelled, because the page was hidden.")};document.addEventListener("visibilitychange",m);let g=()=>{let{rounds:v,live:S}=t;if(o.length!==v.length+1){let b=o.value;o.replaceChildren(_("option",{value:0},"Whole run"),...v.map(({number:T},R)=>_("option",{value:R+1},`Round ${T}`))),b&&(o.value=b)}a.disabled=n!==null||S||s!==null||!v.length,S&&!n&&zt(h,"A live run can be recorded once it has ended."),zt(a,`Record at ${Math.max(1,e.speed)}\xD7`)};return g(),{element:_("details",{class:"w-film",name:"w-menu"},_("summary",{},"Film"),_("div",{},o,a,l,c,u,h)),show:g,destroy:()=>{document.removeEventListener("visibilitychange",m),x(),s&&d(""),URL.revokeObjectURL(u.href)}}}var Xx=[["Space","play, pause"],["\u2190 \u2192","0.1 s back, forward (with Shift: 1 s)"],["[ ]","previous, next event or stroke"],["Home End","start, end"],["+ \u2212","faster, slower"],["L","follow a live run"],["F","fit view"],["T","follow the work: wide in free motion, close at strokes"],["V","view from above"],["W A S D","turn the scene (while it has the focus)"],["Z X","zoom in, out (while the scene has the focus)"],["Drag","on the plot of forces: select that part of the path"]];function bu(i,t,e){return(e>0?i.find(s=>s>t+.05):i.findLast(s=>s<t-.05))??(e>0?i.at(-1)??t:i[0]??t)}var vu=[],ZE=(i,t)=>i instanceof HTMLElement?i.isContentEditable||/^(TEXTAREA|SELECT)$/.test(i.tagName)?!0:i instanceof HTMLInputElement&&i.type==="range"?/^(Arrow|Page|Home$|End$)/.test(t):i instanceof HTMLInputElement?!(i.type==="checkbox"&&t!==" "):t===" "&&/^(BUTTON|A|SUMMARY)$/.test(i.tagName):!1;function qx(i,t,e,n){vu.push(i);let s=a=>{t.playing&&t.pause(),t.seek(t.time+a)},r={" ":()=>t.toggle(),ArrowLeft:a=>s(a?-1:-.1),ArrowRight:a=>s(a?1:.1),"[":()=>t.seek(bu(e.stops,t.time,-1)),"]":()=>t.seek(bu(e.stops,t.time,1)),Home:()=>t.seek(0),End:()=>t.seek(t.end),"+":()=>t.faster(1),"=":()=>t.faster(1),"-":()=>t.faster(-1)},o=a=>{if(a.ctrlKey||a.metaKey||a.altKey||a.defaultPrevented||ZE(a.target,a.key))return;let l=a.target,c=l===document.body||l===document.documentElement;if(!i.contains(l)&&!(c&&vu[0]===i))return;let h=r[a.key];if(h)h(a.shiftKey);else if(!n(a.key.toLowerCase()))return;a.preventDefault()};return document.addEventListener("keydown",o),()=>{document.removeEventListener("keydown",o),vu.splice(vu.indexOf(i),1)}}var jE=13,Ap=i=>new Path2D(`M32 ${32-i}l${i} ${i}l${-i} ${i}l${-i} ${-i}z`),Yx=i=>Jh(t=>{t.fillStyle="#000",t.fill(Ap(31)),t.fillStyle="#fff",t.fill(Ap(24)),i&&(t.globalCompositeOperation="destination-out",t.fill(Ap(13)))}),_u=i=>Hi(i,gt("highlight")),wu=class{group=new te;textures={before:Yx(!1),estimated:Yx(!0)};list=[];show(t){this.list=t,ru(this.group),t.forEach(({color:e,pose:n,shape:s,places:r,state:o},a)=>{let l=new Ft;l.setAttribute("position",new Vt(r.flatMap(([u,d])=>oi(s,u,d,2*Sn)),3));let c=new Wn({size:jE,sizeAttenuation:!1,map:this.textures[o],alphaTest:.3,transparent:!0});c.color.set(_u(e));let h=new ni(l,yn(c,.98));h.matrixAutoUpdate=!1,ce(n,h.matrix),h.frustumCulled=!1,h.renderOrder=7+a/(t.length+1),this.group.add(h)})}paint(){this.points.forEach(({material:t},e)=>t.color.set(_u(this.list[e].color)))}get points(){return this.group.children}};var uo=8,Zx=i=>Math.min(uo-1,Math.max(0,Math.floor(i*uo))),jx=()=>_("div",{class:"w-scale w-reach"},_("b",{},"Base poses"),_("ul",{"aria-label":"Scale in percent"},...Array.from({length:uo},(i,t)=>_("li",{},_("i",{"aria-hidden":"true",style:`background:var(--band-${t+1})`}),`\u2265 ${Ct(t/uo,t%2)}`))),_("p",{},"share of the path that is in reach; the tip points where the base faces; ringed: chosen, in order"));var Ja=new A;function Zn(i,t,e,n,s,r){let o=2*Math.PI*s/4,a=Math.max(r-2*s,0),l=Math.PI/4;Ja.copy(t),Ja[n]=0,Ja.normalize();let c=.5*o/(o+a),h=1-Ja.angleTo(i)/l;return Math.sign(Ja[e])===1?h*c:a/(o+a)+c+c*(1-h)}var Mu=class i extends Ln{constructor(t=1,e=1,n=1,s=2,r=.1){let o=s*2+1;if(r=Math.min(t/2,e/2,n/2,r),super(1,1,1,o,o,o),this.type="RoundedBoxGeometry",this.parameters={width:t,height:e,depth:n,segments:s,radius:r},o===1)return;let a=this.toNonIndexed();this.index=null,this.attributes.position=a.attributes.position,this.attributes.normal=a.attributes.normal,this.attributes.uv=a.attributes.uv;let l=new A,c=new A,h=new A(t,e,n).divideScalar(2).subScalar(r),u=this.attributes.position.array,d=this.attributes.normal.array,f=this.attributes.uv.array,p=u.length/6,x=new A,m=.5/o;for(let g=0,v=0;g<u.length;g+=3,v+=2)switch(l.fromArray(u,g),c.copy(l),c.x-=Math.sign(c.x)*m,c.y-=Math.sign(c.y)*m,c.z-=Math.sign(c.z)*m,c.normalize(),u[g+0]=h.x*Math.sign(l.x)+c.x*r,u[g+1]=h.y*Math.sign(l.y)+c.y*r,u[g+2]=h.z*Math.sign(l.z)+c.z*r,d[g+0]=c.x,d[g+1]=c.y,d[g+2]=c.z,Math.floor(g/p)){case 0:x.set(1,0,0),f[v+0]=Zn(x,c,"z","y",r,n),f[v+1]=1-Zn(x,c,"y","z",r,e);break;case 1:x.set(-1,0,0),f[v+0]=1-Zn(x,c,"z","y",r,n),f[v+1]=1-Zn(x,c,"y","z",r,e);break;case 2:x.set(0,1,0),f[v+0]=1-Zn(x,c,"x","z",r,t),f[v+1]=Zn(x,c,"z","x",r,n);break;case 3:x.set(0,-1,0),f[v+0]=1-Zn(x,c,"x","z",r,t),f[v+1]=1-Zn(x,c,"z","x",r,n);break;case 4:x.set(0,0,1),f[v+0]=1-Zn(x,c,"x","y",r,t),f[v+1]=1-Zn(x,c,"y","x",r,e);break;case 5:x.set(0,0,-1),f[v+0]=Zn(x,c,"x","y",r,t),f[v+1]=1-Zn(x,c,"y","x",r,e);break}}static fromJSON(t){return new i(t.width,t.height,t.depth,t.segments,t.radius)}};var Cp=new A(0,0,1),qi=(i,t=new A)=>new Lt().makeRotationFromQuaternion(new Le().setFromUnitVectors(Cp,i.clone().normalize())).setPosition(t),Jx=(i,t,e)=>new Ft().setAttribute("position",new re(i,3)).setAttribute("normal",new re(t,3)).setIndex(e);function Su(i,t,e,n,s){i[3*t]=e,i[3*t+1]=n,i[3*t+2]=s}function Qe(i,t=24){let e=new Float32Array(3*(t+1)*i.length),n=new Float32Array(e.length),s=[],r=i.slice(1).map(([a,l],c)=>({out:l-i[c][1],up:i[c][0]-a})),o=i.map((a,l)=>{let[c,h]=[(r[l-1]?.out??0)+(r[l]?.out??0),(r[l-1]?.up??0)+(r[l]?.up??0)],u=Math.hypot(c,h)||1;return{out:c/u,up:h/u}});for(let a=0;a<=t;a++){let l=2*Math.PI*a/t,c=Math.cos(l),h=Math.sin(l);for(let u=0;u<i.length;u++){let d=i[u][0],{out:f,up:p}=o[u],x=a*i.length+u;Su(e,x,d*c,d*h,i[u][1]),Su(n,x,f*c,f*h,p);let m=r[u];if(a===0||!m||m.out===0&&m.up===0)continue;let g=x-i.length;d>0&&s.push(g,x,x+1),i[u+1][0]>0&&s.push(g,x+1,g+1)}}return Jx(e,n,s)}function Tu({from:i,to:t,radius:e},n,s,r){let o=t.x-i.x,a=t.y-i.y,l=t.z-i.z,c=o*o+a*a+l*l,h=c>0?Math.min(1,Math.max(0,((n-i.x)*o+(s-i.y)*a+(r-i.z)*l)/c)):0;return Math.hypot(n-i.x-h*o,s-i.y-h*a,r-i.z-h*l)-e}var Kx=.012,Rp=.01,Qa=1e-4,KE=12;function JE({rods:i,box:t,edge:e},n,s,r){let o=0;for(let u of i)o+=Math.exp(-Tu(u,n,s,r)/Kx);let a=Math.abs(n)-t.x+e,l=Math.abs(s)-t.y+e,c=Math.abs(r)-t.z+e,h=Math.hypot(Math.max(0,a),Math.max(0,l),Math.max(0,c))+Math.min(0,Math.max(a,l,c))-e;return Rp*Math.log(o**(-Kx/Rp)+Math.exp(h/Rp))}function QE(i,t){let e=0,[n,s]=[i(0),i(t)];if(n>=0)return 0;let[r,o]=[0,0];for(let a=0;a<KE;a++){r=(e*s-t*n)/(s-n);let l=i(r);if(Math.abs(l)<Qa)break;l<0?([e,n]=[r,l],o<0&&(s/=2)):([t,s]=[r,l],o>0&&(n/=2)),o=Math.sign(l)}return r}function Pp(i,t,[e,n],[s,r],o){let a=Math.ceil((n-e)/o),[l,c]=[Math.asin(s),Math.asin(r)],h=Math.max(2,Math.ceil((c-l)/o)),u=Array.from({length:h+1},(S,b)=>Math.sin(l+b/h*(c-l))),d=[...s<=-1?[-1]:[],...u,...r>=1?[1]:[]],f=new Float32Array(3*(a+1)*d.length),p=new Float32Array(f.length),x=[],[m,g]=[new A,new A],v=(S,b,T)=>JE(i,S,b,T)+t;return d.forEach((S,b)=>{let T=b===0&&s<=-1||b===d.length-1&&r>=1,R=S*(i.box.z-t-Qa);for(let y=0;y<=a;y++){let E=e+(n-e)*y/a,D=Math.cos(E),P=Math.sin(E),k=T?0:QE(H=>v(H*D,H*P,R),2*i.box.length()),O=k*D,B=k*P,I=v(O,B,R);m.set(O,B,R).applyMatrix4(i.linkFromShell),g.set(v(O+Qa,B,R)-I,v(O,B+Qa,R)-I,v(O,B,R+Qa)-I).transformDirection(i.linkFromShell);let V=b*(a+1)+y;Su(f,V,m.x,m.y,m.z),Su(p,V,g.x,g.y,g.z);let X=V-a-1;b>0&&y<a&&x.push(X,X+1,V,V,X+1,V+1)}}),Jx(f,p,x)}var tA=.8,eA=[15,85,155,225],nA=[8,40,72,104],iA=[-30,-95,-160],Ip=(...[i,t,e,n])=>new Mu(i,t,e,2,n);function ty(i,t,e,n){let s=t.to.clone().sub(t.from),r=s.lengthSq()>0?s.normalize():Cp.clone(),o=e?e.back.clone().sub(t.to).dot(r):1/0,a=o>tA*t.radius,l=e?(a?e.normal:e.side).clone():new A(1,0,0),c=l.addScaledVector(r,-l.dot(r));c.lengthSq()<1e-4&&c.set(r.y,r.z,r.x).cross(r),c.normalize();let h=new Lt().makeBasis(c,r.clone().cross(c),r).setPosition(t.to),u=(f,p,x=new Lt)=>i(f,p,h.clone().multiply(x)),d=t.to.distanceTo(t.from);a?sA(u,t.radius,d,e!==null,n):rA(u,t.radius,d,o,e.sizes[0]/2),e&&oA(u,a,t.radius,e,h)}var fo=(i,t,e)=>new Lt().makeTranslation(i,t,e),ey=(i,t)=>qi(t.clone().sub(i),i.clone().lerp(t,.5));function sA(i,t,e,n,s){let[r,o]=[-e-1.05*t,-.62*t];i("casing",Qe([[0,r],[.36*t,r],[.42*t,r+.1*t],[.42*t,r+.3*t],[.33*t,o-.25*t],[.3*t,o],[0,o]],24)),i("joint",Qe([[.3*t,o-.32*t],[.37*t,o-.3*t],[.37*t,o-.14*t],[.3*t,o-.12*t]],24)),i("ring",Qe([[.4*t,r+.34*t],[.435*t,r+.34*t],[.43*t,r+.4*t],[.39*t,r+.4*t]],24)),i("casing",Ip(.27*t,1.02*t,1.25*t,.11*t),fo(.29*t,0,-.06*t)),i("joint",Ip(.1*t,.8*t,.8*t,.04*t),fo(.41*t,0,-.1*t));let[a,l]=n?[eA,.25*t]:[nA,.42*t],c=new A(n?0:-.12*t,0,(n?.45:.3)*t);for(let h of[-.385,-.14,.14,.385])Qx(i,a,l,c.clone().setY(h*t),.088*t);Qx(i,iA,l,c.clone().setY((s?-.3:.3)*t),.1*t)}function Qx(i,t,e,n,s){let r=t.map(o=>{let a=o*Math.PI/180;return new A(Math.cos(a),0,Math.sin(a)).multiplyScalar(e).add(n)});r.slice(1).forEach((o,a)=>{let l=r[a],[c,h]=[l.distanceTo(o)/2,s*(1-.06*a)],u=a===r.length-2?c+.6*h:c-.35*h;i("casing",Qe([[0,-c],[.85*h,.35*h-c],[h,.6*h-c],[h,u-.5*h],[.8*h,u-.1*h],[0,u]],12),ey(l,o)),i("joint",new ki(.98*h,10,6),fo(l.x,l.y,l.z))})}function rA(i,t,e,n,s){let r=-e-.9*t;i("casing",Qe([[0,r],[.8*t,r],[.84*t,r+.08*t],[.84*t,-.2*t],[.76*t,-.12*t],[0,-.12*t]],28)),i("ring",Qe([[.84*t,-.5*t],[.88*t,-.48*t],[.88*t,-.36*t],[.84*t,-.34*t]],28)),i("joint",Ip(1.5*t,.86*t,.42*t,.08*t),fo(0,0,.02*t));let o=.16*t,a=.3*t,l=Math.min(s,.75*t)+o/2,c=Math.sqrt(Math.max(0,(t+.008)**2-(l+o/2)**2-a**2)),h=Math.min(n+.012,c);for(let u of[-l,l])i("casing",new Ln(o,2*a,h-.05*t),fo(u,0,(h+.05*t)/2))}function oA(i,t,e,{back:n,normal:s,side:r,sizes:o},a){let l=a.clone().invert(),c=n.clone().applyMatrix4(l),h=new Lt().extractRotation(l),u=new Lt().makeBasis(r.clone().transformDirection(h),s.clone().cross(r).transformDirection(h),s.clone().transformDirection(h)),d=.006;if(i("handle",new Ln(.62*o[0],.62*o[1],d),u.setPosition(c)),!t)return;let f=new A(0,0,.45*e);i("handle",new Is(.12*e,.98*e,4,14),fo(f.x,f.y,f.z)),i("handle",Qe([[.075*e,-f.distanceTo(c)/2],[.075*e,f.distanceTo(c)/2]],12),ey(f,c))}var po=class{worldFromLink;joints;motion=new Lt;constructor(t){this.joints=t.map(e=>({...e,parentFromJoint:ce(e.pose),direction:new A(...e.axis)})),this.worldFromLink=Array.from({length:t.length+1},()=>new Lt)}update(t,e){ce(t,this.worldFromLink[0]),this.joints.forEach(({parent:n,parentFromJoint:s,direction:r,kind:o,offset:a,terms:l},c)=>{let h=a;for(let[d,f]of l)h+=f*(e[d]||0);let u=this.worldFromLink[c+1].multiplyMatrices(this.worldFromLink[n],s);o==="revolute"?u.multiply(this.motion.makeRotationAxis(r,h)):o==="prismatic"&&u.multiply(this.motion.makeTranslation(r.x*h,r.y*h,r.z*h))})}};var aA=.56,ny=.82,sy=.005,ry=.03,iy=.9;function oy({robot:i,tool:t},e){if(!i)return[];let n=lA(i);return i.links.map(({name:s,arm:r,shapes:o},a)=>{let l={casing:[],joint:[],ring:[],handle:[]},c=(x,m,g)=>{if(!m.hasAttribute("position"))return;m.deleteAttribute("uv");let v=m.index?m:z0(m);l[x].push(g?v.applyMatrix4(g):v)},h=n[a],[u]=h.rods,d=Au(h,h.before?[h.before,...h.after]:h.after),f=hA(t,e,i,n,h),p=o.length===1&&!h.after.length&&(f!==null||h.before?.after.length===1);if(u&&!r&&/head/i.test(s))xA(c,u,h.worldFromLink);else if(u&&p)ty(c,u,f,/left/i.test(s));else if(!h.trunk||!gA(c,h))for(let x of h.rods)uA(c,x,d);for(let x of o)x.kind!=="capsule"&&yA(c,x,r?null:h.worldFromLink,e);return h.before&&fA(c,i.joints[a-1],h),Object.fromEntries(Object.entries(l).filter(([,x])=>x.length).map(([x,m])=>[x,B0(m)]))})}var tl=i=>i.clone().invert(),Dp=(i,t)=>i.map(({from:e,to:n,radius:s})=>({from:e.clone().applyMatrix4(t),to:n.clone().applyMatrix4(t),radius:s})),Au=({worldFromLink:i},t)=>t.flatMap(({rods:e,worldFromLink:n})=>Dp(e,tl(i).multiply(n)));function lA(i){let t=new po(i.joints);t.update([0,0,0,0,0,0,1],[]);let e=[];return i.links.forEach(({arm:n,shapes:s},r)=>{let o=i.joints[r-1],a=o?e[o.parent]:null,l=a&&(a.rods.length?a:a.before),c=t.worldFromLink[r],h=s.flatMap(m=>m.kind==="capsule"?[cA(m)]:[]),u=l?Au({worldFromLink:c},[l]).flatMap(({from:m,to:g})=>[m,g]):[new A],d=m=>Math.min(...u.map(g=>g.distanceTo(m)));for(let m of h)d(m.to)<d(m.from)-1e-6&&([m.from,m.to]=[m.to,m.from]);let f=new A().setFromMatrixPosition(c),p=a!==null&&l!==a&&f.distanceTo(new A().setFromMatrixPosition(a.worldFromLink))<.001&&!dA(i.joints[a.index-1],a),x={index:r,rods:h,before:l,after:[],worldFromLink:c,trunk:!n&&h.length>0&&(h.length>1||!l),crossed:p};h.length&&l?.after.push(x),e.push(x)}),e}function cA({pose:i,length:t,radius:e}){let n=ce(i),[s,r]=[-t/2,t/2].map(o=>new A(0,0,o).applyMatrix4(n));return{from:s,to:r,radius:e}}function hA(i,t,{joints:e},n,s){let r=i.link??0;for(;r>s.index&&e[r-1].kind==="fixed";)r=e[r-1].parent;if(i.link===null||r!==s.index)return null;let o=n[i.link],a=tl(s.worldFromLink).multiply(o.worldFromLink).multiply(ce(i.solid.pose)),l=zi(i.solid,t);l.computeBoundingBox();let c=l.boundingBox,h=c.getSize(new A),u=h.x<=h.y?"x":"y",d=f=>new A().setComponent("xyz".indexOf(f),1).transformDirection(a);return{back:c.getCenter(new A).setZ(c.max.z).applyMatrix4(a),normal:d("z"),side:d(u),sizes:u==="x"?[h.x,h.y]:[h.y,h.x]}}function uA(i,{from:t,to:e,radius:n},s){let r=e.clone().sub(t),o=r.length()/2,a=qi(o>0?r:new A(0,0,1),t.clone().lerp(e,.5)),l=Math.min(1,2*o/n),c=m=>n*(ny-(ny-aA)*l*(1-Math.sin(Math.PI*Math.min(1,Math.max(0,m))**.7)**.8)-.06*m),h=m=>{let[g,v]=m>0?[e,r]:[t,r.clone().negate()],[S]=s.flatMap(b=>[b.from,b.to]).sort((b,T)=>b.distanceTo(g)-T.distanceTo(g));return S!==void 0&&S.clone().sub(g).dot(v)>.3*n*v.length()},u=(m,g)=>Array.from({length:4},(v,S)=>{let b=Math.PI/2*(m<0?S/4:1-(S+1)/4);return[g*Math.sin(b),m*(o+(h(m)?.95*n:.6*g)*Math.cos(b))]}),d=[...u(-1,c(0)),...Array.from({length:15},(m,g)=>[c(g/14),o*(g/7-1)]),...u(1,c(1))];if(i("casing",Qe(d),a),o<.25*n)return;let[f,p]=[.16,.16+.06*n/(2*o)],x=[f,p].map(m=>[c(m)+.02*n,o*(2*m-1)]);i("ring",Qe([[c(f),x[0][1]],x[0],x[0],x[1],x[1],[c(p),x[1][1]]]),a)}var dA=({axis:i},t)=>ay(new A(...i),t)!==null;function ay(i,t){let{rods:e,before:n}=t,s=e.find(({from:r,to:o,radius:a})=>Math.abs(o.clone().sub(r).normalize().dot(i))>iy&&r.clone().cross(i).length()<.3*a);if(s)return{z:s.from.dot(i)+Math.sign(s.to.clone().sub(s.from).dot(i))*-.1*s.radius,radius:.7*s.radius};if(!n||n.trunk)return null;for(let{from:r,to:o,radius:a}of Au(t,[n])){let l=o.clone().sub(r).normalize().dot(i),[c,h]=o.length()>1.5*a?[-.45,.56]:[.55,.64];if(Math.abs(l)>iy)return{z:o.dot(i)-Math.sign(l)*c*a,radius:h*a}}return null}function fA(i,t,e){if(t.kind!=="revolute")return;let n=new A(...t.axis).normalize(),s=ay(n,e);if(s){let[u,d]=[s.radius*1.06,.13*s.radius];i("joint",Qe([[0,-d],[u*.94,-d],[u,-.6*d],[u,.6*d],[u*.94,d],[0,d]]),qi(n,n.clone().multiplyScalar(s.z)));return}let r=Au(e,[e.before,...e.rods.length?[]:e.after]),{room:o,along:a}=Lp(n,[...r,...e.rods]);if(o<ry)return;pA(i,n,Lp(n,r),Lp(n,e.rods));let l=o+sy,[c,h]=e.crossed?[.6*l,.79*l]:[.76*l,.64*l];ly(i,qi(n,n.clone().multiplyScalar(a)),c,h)}function ly(i,t,e,n){let s=l=>l.map(([c,h])=>[c,-h]),r=[[.66*e,n],[.66*e,n],[.88*e,n],[.88*e,n],[e,n-.12*e],[e,n-.12*e]],o=[[0,n-.1*e],[.5*e,n-.1*e],[.58*e,n-.05*e],[.58*e,n-.05*e],[.6*e,n-.2*e]],a=[[.6*e,n-.2*e],[.6*e,n],[.6*e,n],[.7*e,n+.012*e],[.7*e,n+.012*e],[.72*e,n-.05*e]];i("joint",Qe([...s(r),...r.toReversed()],28),t);for(let[l,c]of[["casing",o],["ring",a]])i(l,Qe(s(c)),t),i(l,Qe(c.toReversed()),t)}function Lp(i,t){let e=s=>Math.max(-1,...t.map(r=>-Tu(r,s*i.x,s*i.y,s*i.z))),n={room:e(0),along:0};for(let s=-.3;s<=.3;s+=.01)e(s)>n.room/.75+.001&&Object.assign(n,{room:e(s),along:s});return n}function pA(i,t,e,n){let s=Math.abs(e.along-n.along),r=Math.min(e.room,n.room);if(r<ry||s<r||s>e.room+n.room+sy)return;let o=.5*r;i("joint",Qe([[o,-s/2],[o,s/2]]),qi(t,t.clone().multiplyScalar((e.along+n.along)/2)))}function cy(i,t,e,n){let s=new Lt().extractRotation(tl(t)),r=Dp(i,tl(s)),o=new Ne;for(let{from:c,to:h,radius:u}of r)for(let d of[c,h])o.expandByPoint(d.clone().addScalar(u)).expandByPoint(d.clone().addScalar(-u));let a=o.getCenter(new A),l=o.getSize(new A).multiplyScalar(.5).multiply(new A(...e));return{linkFromShell:s.clone().setPosition(a.clone().applyMatrix4(s)),box:l,edge:n*Math.min(l.x,l.y,l.z),rods:Dp(r,new Lt().makeTranslation(a.negate()))}}var Eu=[-Math.PI,Math.PI],mA=i=>[-i,i],hy=i=>[i+.04,2*Math.PI-i-.04];function uy(i,t,e,n){i("joint",Pp(t,n,Eu,[-1,1],Math.PI/12));for(let[s,r]of e)i("casing",Pp(t,0,s,r,Math.PI/15))}function gA(i,{rods:t,worldFromLink:e}){let n=cy(t,e,[.94,.9,.95],.5);return n.rods.some(s=>Tu(s,0,0,0)<-.5*s.radius)?(uy(i,n,[[mA(.75),[-.62,.5]],[hy(.75),[-.62,.5]],[Eu,[.53,1]]],.008),!0):!1}function xA(i,t,e){let n=t.radius,s=cy([t],e,[.84,.72,.8],.62);uy(i,s,[[Eu,[.5,1]],[hy(.95),[-.3,.48]],[Eu,[-1,-.32]]],.01);for(let r of[-.26,.26]){let o=new A(s.box.x-.012,r*n,.12*n).applyMatrix4(s.linkFromShell);i("ring",Qe([[.13*n,-.01],[.13*n,0],[.1*n,.008],[0,.009]],18),qi(new A(1,0,0).transformDirection(s.linkFromShell),o))}}function yA(i,t,e,n){let s=o=>Math.abs(new A().setFromMatrixPosition(ce(t.pose)).applyMatrix4(e).z-o)<.1*o;if(t.kind!=="sphere"||!e||!s(t.radius))return i("casing",zi(t,n).clone(),ce(t.pose));let r=new A(0,1,0).transformDirection(tl(e));ly(i,qi(r,new A().setFromMatrixPosition(ce(t.pose))),.9*t.radius,.42*t.radius)}var dy=()=>new Nn({transparent:!0,opacity:.22,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2}),kp=i=>!i.links.some(({visual:t})=>t);function vA(i,t){let{robot:e}=i;return e?kp(e)?oy(i,t).map(n=>Object.entries(n).map(([s,r])=>({geometry:r,linkFromPart:new Lt,look:s}))):e.links.map(({shapes:n})=>n.map(s=>({geometry:zi(s,t),linkFromPart:ce(s.pose),look:s.color??"casing"}))):[]}function Np(i,t,e){let n=new ae(i,t);return n.matrixAutoUpdate=!1,n.matrix.copy(e),n}var el=class{constructor(t,e,n,s){this.head=t;this.meshes=e;this.materials=n;let{robot:r,tool:o}=t;this.tree=r?new po(r.joints):null,this.parts=s?.parts??vA(t,e),this.parts.forEach((a,l)=>{let c=new te;c.matrixAutoUpdate=!1;let h=r.links[l].arm?n.arm:n.body;for(let{geometry:u,linkFromPart:d,look:f}of a){let p=Np(u,typeof f!="string"?n.coloured(f):f==="casing"?h:n[f],d);p.castShadow=p.receiveShadow=!s,c.add(p)}this.links.push(c),this.group.add(c)}),this.linkFromTool=ce(o.solid.pose),this.tool=Np(s?.tool.geometry??zi(o.solid,e),n.tool,this.linkFromTool),this.tool.castShadow=!s,this.group.add(this.tool)}head;meshes;materials;group=new te;tool;tree;links=[];collision=[];linkFromTool;parts;show(t,e,n){let s=this.tree!==null&&e.length>0;for(let a of this.links)a.visible=s;this.tree&&s&&(this.tree.update(t??[0,0,0,0,0,0,1],e),this.links.forEach((a,l)=>{a.matrix.copy(this.tree.worldFromLink[l]),a.matrixWorldNeedsUpdate=!0}));let{link:r}=this.head.tool,o=r!==null&&s?this.tree.worldFromLink[r]:void 0;this.tool.visible=o!==void 0||n!==null,o?this.tool.matrix.multiplyMatrices(o,this.linkFromTool):n&&ce(n,this.tool.matrix).multiply(this.linkFromTool),this.tool.matrixWorldNeedsUpdate=!0}set collisionShown(t){t&&!this.collision.length&&this.head.robot?.links.forEach((e,n)=>{for(let s of Op(e)){let r=Np(zi(s,this.meshes),this.materials.collision,ce(s.pose));this.collision.push(r),this.links[n].add(r)}});for(let e of this.collision)e.visible=t}get triangles(){return[this.tool.geometry,...this.parts.flat().map(({geometry:t})=>t)].reduce((t,{index:e,attributes:n})=>t+(e?.count??n.position.count)/3,0)}set last(t){for(let e of this.links)for(let n of e.children)n.renderOrder=t?9:0}get toolPlace(){return new A().setFromMatrixPosition(this.tool.matrix)}get rootPlace(){return new A().setFromMatrixPosition(this.links.find(t=>t.children.length)?.matrix??new Lt)}},Op=({visual:i,shapes:t,collision:e})=>i?e??[]:t;var fy={type:"change"},Up={type:"start"},my={type:"end"},Ru=new pi,py=new Pn,bA=Math.cos(70*jr.DEG2RAD),Fe=new A,Tn=2*Math.PI,ue={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Fp=1e-6,Cu=class extends Ma{constructor(t,e=null){super(t,e),this.state=ue.NONE,this.target=new A,this.cursor=new A,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:cs.ROTATE,MIDDLE:cs.DOLLY,RIGHT:cs.PAN},this.touches={ONE:hs.ROTATE,TWO:hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new A,this._lastQuaternion=new Le,this._lastTargetPosition=new A,this._quat=new Le().setFromUnitVectors(t.up,new A(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wr,this._sphericalDelta=new Wr,this._scale=1,this._panOffset=new A,this._rotateStart=new st,this._rotateEnd=new st,this._rotateDelta=new st,this._panStart=new st,this._panEnd=new st,this._panDelta=new st,this._dollyStart=new st,this._dollyEnd=new st,this._dollyDelta=new st,this._dollyDirection=new A,this._mouse=new st,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=wA.bind(this),this._onPointerDown=_A.bind(this),this._onPointerUp=MA.bind(this),this._onContextMenu=PA.bind(this),this._onMouseWheel=EA.bind(this),this._onKeyDown=AA.bind(this),this._onTouchStart=RA.bind(this),this._onTouchMove=CA.bind(this),this._onMouseDown=SA.bind(this),this._onMouseMove=TA.bind(this),this._interceptControlDown=IA.bind(this),this._interceptControlUp=LA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ue.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(fy),this.update(),this.state=ue.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Fe.copy(e).sub(this.target),Fe.applyQuaternion(this._quat),this._spherical.setFromVector3(Fe),this.autoRotate&&this.state===ue.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Tn:n>Math.PI&&(n-=Tn),s<-Math.PI?s+=Tn:s>Math.PI&&(s-=Tn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Fe.setFromSpherical(this._spherical),Fe.applyQuaternion(this._quatInverse),e.copy(this.target).add(Fe),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Fe.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new A(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new A(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Fe.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Ru.origin.copy(this.object.position),Ru.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ru.direction))<bA?this.object.lookAt(this.target):(py.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ru.intersectPlane(py,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Fp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Fp||this._lastTargetPosition.distanceToSquared(this.target)>Fp?(this.dispatchEvent(fy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Tn/60*this.autoRotateSpeed*t:Tn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Fe.setFromMatrixColumn(e,0),Fe.multiplyScalar(-t),this._panOffset.add(Fe)}_panUp(t,e){this.screenSpacePanning===!0?Fe.setFromMatrixColumn(e,1):(Fe.setFromMatrixColumn(e,0),Fe.crossVectors(this.object.up,Fe)),Fe.multiplyScalar(t),this._panOffset.add(Fe)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Fe.copy(s).sub(this.target);let r=Fe.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Tn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Tn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Tn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Tn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Tn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Tn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Tn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Tn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new st,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function _A(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function wA(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function MA(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(my),this.state=ue.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function SA(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case cs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=ue.DOLLY;break;case cs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=ue.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=ue.ROTATE}break;case cs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=ue.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=ue.PAN}break;default:this.state=ue.NONE}this.state!==ue.NONE&&this.dispatchEvent(Up)}function TA(i){switch(this.state){case ue.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case ue.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case ue.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function EA(i){this.enabled===!1||this.enableZoom===!1||this.state!==ue.NONE||(i.preventDefault(),this.dispatchEvent(Up),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(my))}function AA(i){this.enabled!==!1&&this._handleKeyDown(i)}function RA(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case hs.ROTATE:if(this.enableRotate===!1){this.state=ue.NONE;break}this._handleTouchStartRotate(i),this.state=ue.TOUCH_ROTATE;break;case hs.PAN:if(this.enablePan===!1){this.state=ue.NONE;break}this._handleTouchStartPan(i),this.state=ue.TOUCH_PAN;break;default:this.state=ue.NONE}break;case 2:switch(this.touches.TWO){case hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=ue.TOUCH_DOLLY_PAN;break;case hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=ue.TOUCH_DOLLY_ROTATE;break;default:this.state=ue.NONE}break;default:this.state=ue.NONE}this.state!==ue.NONE&&this.dispatchEvent(Up)}function CA(i){switch(this._trackPointer(i),this.state){case ue.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case ue.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case ue.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case ue.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=ue.NONE}}function PA(i){this.enabled!==!1&&i.preventDefault()}function IA(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function LA(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Pu=Math.PI/24,DA=380,Iu=class{constructor(t,e,n){this.taken=n;this.lens.up.set(0,0,1),this.controls=new Cu(this.lens,t),this.controls.maxPolarAngle=.62*Math.PI,this.controls.minDistance=.1,this.controls.maxDistance=40,this.controls.zoomToCursor=!0,this.controls.addEventListener("start",()=>{this.held=!0}),this.controls.addEventListener("end",()=>{this.held=!1}),this.controls.addEventListener("change",()=>{this.held&&this.take(),e()}),t.addEventListener("wheel",s=>{let{scrollHeight:r,clientHeight:o}=document.documentElement;this.controls.enableZoom=s.ctrlKey||document.activeElement===t||r<=o+1},{capture:!0,passive:!0}),t.addEventListener("pointerdown",()=>{this.controls.enableZoom=!0,t.focus({preventScroll:!0})},!0),t.addEventListener("keydown",s=>{if(s.ctrlKey||s.metaKey||s.altKey)return;let r={a:[-Pu,0],d:[Pu,0],w:[0,-Pu],s:[0,Pu]},o={z:1/1.15,x:1.15},[a,l]=[r[s.key],o[s.key]];if(a)this.turn(...a);else if(l)this.zoom(l);else return;s.preventDefault(),s.stopPropagation()})}taken;lens=new fn(36,1,.02,200);controls;open=1;goal=null;stepped=0;asked=!1;held=!1;get angles(){let t=Math.tan(this.lens.fov*Math.PI/360);return{high:t,wide:t*this.lens.aspect*this.open}}look(t,e=!1){if(t){if(this.goal=e&&!matchMedia("(prefers-reduced-motion: reduce)").matches?t:null,this.stepped=performance.now(),this.asked=e,!this.goal)return this.move(t);this.controls.dispatchEvent({type:"change"})}}step(){if(!this.goal)return!1;let t=performance.now(),e=1-Math.exp((this.stepped-t)/DA);this.stepped=t;let{goal:n}=this,s=this.controls.target.clone().lerp(n.target,e),r=this.lens.position.clone().lerp(n.eye,e);return r.distanceTo(n.eye)+s.distanceTo(n.target)<.002*r.distanceTo(s)&&(this.goal=null),this.move(this.goal?{target:s,eye:r}:n),this.goal!==null}followLinked(t,e){e&&this.take(),this.goal=null,this.move(t)}get view(){return{target:this.controls.target.clone(),eye:this.lens.position.clone()}}pixelsPerMetre(t,e){let n=t?new A().setFromMatrixPosition(t.matrix):this.controls.target;return e/(2*Math.tan(this.lens.fov*Math.PI/360)*Math.max(.05,n.distanceTo(this.lens.position)))}shape(t,e,n){this.lens.aspect=t/e,this.open=(t-n)/t,this.lens.setViewOffset(t,e,-n/2,0,t,e)}move({target:t,eye:e}){let{held:n}=this;this.held=!1,this.controls.target.copy(t),this.lens.position.copy(e),this.controls.update(),this.held=n}take(){this.goal=null,this.asked=!0,this.taken()}turn(t,e){this.take();let n=this.lens.position.clone().sub(this.controls.target);n.applyAxisAngle(new A(0,0,1),t);let s=new A().crossVectors(this.lens.up,n).normalize(),r=n.clone().applyAxisAngle(s,e),o=r.angleTo(this.lens.up);o>.02&&o<this.controls.maxPolarAngle&&n.copy(r),this.lens.position.copy(this.controls.target).add(n),this.controls.update()}zoom(t){this.take();let e=this.lens.position.clone().sub(this.controls.target).multiplyScalar(t);this.lens.position.copy(this.controls.target).add(e),this.controls.update()}};var NA=.11,kA=.0042,gy=.5,OA=new A(0,1,0),Lu=class{group=new te;shaft;tip;material=new ln({depthTest:!1,transparent:!0,opacity:.95});constructor(t){this.shaft=new ae(new rs(t,t,1,12).translate(0,.5,0),this.material),this.tip=new ae(new Ls(3*t,6*t,16).translate(0,3*t,0),this.material),this.group.add(this.shaft,this.tip),this.group.renderOrder=this.shaft.renderOrder=this.tip.renderOrder=8}show(t,e,n){let s=e.length();this.group.visible=s>.001,this.group.visible&&(this.group.position.copy(t),this.group.quaternion.setFromUnitVectors(OA,e.clone().divideScalar(s)),this.shaft.scale.set(n,s,n),this.tip.position.y=s,this.tip.scale.setScalar(Math.min(n,s/9)))}},Du=class{group=new te;whole=new Lu(1);pressed=new Lu(.5);constructor(){this.group.add(this.whole.group,this.pressed.group),this.paint()}paint(){this.whole.material.color=new Mt(gt("force")),this.pressed.material.color=new Mt(gt("ink"))}show(t,e,n,s){let{force:r,normal:o,round:a}=t,l=r?Math.hypot(...r):0;if(this.group.visible=s&&l>gy,!this.group.visible||!r)return;let c=NA/Math.max(10,a.normal.largest,l),h=kA*n.distanceTo(e);this.whole.show(e,new A(...r).multiplyScalar(c),h);let u=ms(a.plan.surface,e);this.pressed.show(e,u.multiplyScalar(Math.abs(o??0)>gy?(o??0)*c:0),h)}};var FA=[[-1,-1],[1,-1],[1,1],[-1,1]];function UA({record:i,shape:t}){let e=ve(i.places),[n,s]=i.cell.map(c=>Ga*c),r=e.length/2,o=new Float32Array(12*r),a=[];for(let c=0;c<r;c++)FA.forEach(([h,u],d)=>o.set(oi(t,e[2*c]+h*n,e[2*c+1]+u*s,Sn/2),12*c+3*d)),a.push(4*c,4*c+1,4*c+2,4*c,4*c+2,4*c+3);let l=new Ft;return l.setAttribute("position",new re(o,3)),l.setAttribute("color",new re(new Float32Array(12*r),3)),l.setIndex(a),l}var Nu=class{mesh=new ae(new Ft,yn(new ln({vertexColors:!0,side:cn,toneMapped:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),.997));shown=null;theme="";constructor(){this.mesh.matrixAutoUpdate=!1,this.mesh.frustumCulled=!1}show(t,e){if(this.mesh.visible=t!==null,!t)return;ce(t.pose,this.mesh.matrix),this.mesh.matrixWorldNeedsUpdate=!0;let n=this.shown?.record===t.record&&this.shown.shape===t.shape;n||(this.mesh.geometry.dispose(),this.mesh.geometry=UA(t)),(!n||this.shown?.values!==t.values||this.theme!==e)&&this.paint(t),this.shown=t,this.theme=e}paint({record:t,values:e}){let n=ys(t),s=n.map(o=>new Mt(gt(o.colour))),r=this.mesh.geometry.getAttribute("color");e.forEach((o,a)=>{let{r:l,g:c,b:h}=s[vs(n,t,o)];for(let u=0;u<4;u++)r.setXYZ(4*a+u,l,c,h)}),r.needsUpdate=!0}};function xy(i,t,e){ai(i),i.textAlign="center",i.textBaseline="middle";let{step:n,times:s}=zh(t.from,t.to,Math.max(2,t.span/76)),r=n<.1?2:n<1?1:0;for(let o of s){let a=t.x(o);Je(i,a,e.top+e.height,a,t.height,"grid"),i.fillStyle=gt("quiet"),i.fillText(oe(o,r),Math.min(Math.max(a,t.left+10),t.width-16),e.top+e.height/2)}}function nl(i,t,e,n=1){if(e<i.from||t>i.to)return null;let s=Math.max(i.x(t),i.left);return[s,Math.max(Math.min(i.x(e),i.width-i.right),s+n)]}function yy(i,t,e,n){ai(i,11,600),i.textAlign="left",i.textBaseline="middle";for(let s of n.rounds){let r=nl(t,s.start,s.end);if(!r)continue;let[o,a]=r;i.fillStyle=gt("round"),i.beginPath(),i.roundRect(o+.5,e.top,Math.max(1,a-o-1),e.height,4),i.fill(),i.fillStyle=gt("ink"),$s(i,`${s.number} \xB7 ${xu(n,s)}`,o+7,e.top+e.height/2+.5,a-o-12),s.start>t.from&&Je(i,t.x(s.start),e.top,t.x(s.start),t.height,"rule")}}function vy(i,t,e,n){ai(i,10.5),i.textAlign="left",i.textBaseline="middle";for(let{start:s,plan:r,length:o}of n.rounds)for(let a of r.phases){let l=nl(t,s+a.start,s+Math.min(a.end,Math.max(o,a.start)));if(!l)continue;let[c,h]=l;i.fillStyle=gt(a.contact?"wiping":"lane"),i.fillRect(c,e.top,Math.max(1,h-c-1),e.height),i.fillStyle=gt(a.contact?"ink":"quiet");let u=a.stroke===null?"":String(a.stroke+1),d=u?`${u} ${a.name}`:hl(a.name),f=e.top+e.height/2+.5;u&&i.measureText(d).width>h-c-7?i.measureText(u).width<=h-c-3&&i.fillText(u,(c+h-i.measureText(u).width)/2,f):$s(i,d,c+4,f,h-c-7)}}function by(i,t,e,n){i.fillStyle=gt("lane"),i.fillRect(t.left,e.top,t.span,e.height);for(let s of n.rounds){if(!nl(t,s.start,s.end))continue;let{contact:r,pushed:o}=s.contacts;for(let[a,l]of[["contact",r],["pushed",o]]){i.fillStyle=gt(a);for(let[c,h]of l){let u=nl(t,s.start+c,s.start+h);u&&(a==="contact"?i.fillRect(u[0],e.top,u[1]-u[0],e.height):BA(i,e,u))}}}}function BA(i,t,[e,n]){i.fillRect(e,t.top,n-e,t.height),i.save(),i.beginPath(),i.rect(e,t.top,n-e,t.height),i.clip();for(let s=e-t.height;s<n;s+=5)Je(i,s,t.top+t.height,s+t.height,t.top,"paper",1.4);i.restore()}function _y(i,t,e){if(!t.count)return;let n=Math.max(Math.floor(i.left),Math.floor(i.x(t.start))),s=Math.min(i.width-i.right,i.x(t.start+t.t.last)),r=t.place(i.t(n)-t.start)[0];for(let o=n;o<=s;o++){let a=t.place(i.t(o+1)-t.start)[0];e(o,r,Math.max(a,r+1)),r=a}}var Bp=({source:i,kind:t,byHand:e})=>i==="push"?"actual":/collision/i.test(t)?"collision":e?"hand":"event";function wy(i,t,e,n){i.fillStyle=gt("lane"),i.fillRect(t.left,e.top,t.span,e.height);let s=e.top+e.height/2;for(let r of n.happenings){let o=nl(t,r.start,r.end,3);if(!o)continue;let[a,l]=o,c=Bp(r);if(i.fillStyle=i.strokeStyle=gt(c),r.source==="push"){i.lineWidth=1.5,i.setLineDash(za),i.strokeRect(a+.5,e.top+1.5,Math.max(2,l-a-1),e.height-3),i.setLineDash([]);continue}i.fillRect(a,s-2.5,l-a,5),zA(i,c,a,s)}}function zA(i,t,e,n){i.beginPath(),t==="collision"?(i.moveTo(e-6,n+5.5),i.lineTo(e+6,n+5.5),i.lineTo(e,n-6),i.closePath()):t==="hand"?i.arc(e,n,5,0,2*Math.PI):i.rect(e-4,n-4,8,8),i.fill(),i.strokeStyle=gt("paper"),i.lineWidth=1,i.stroke()}var GA=13,VA=.006,My={least:.04,most:.16},Sy=.02,HA=1,zp=["collision","hand","actual"];function WA({t:i,force:t,count:e},n,s){let[r,o]=[-1,HA];for(let a=Math.max(0,Gn(i.data,n,e));a<e&&i.data[a]<=s;a++){let l=Math.hypot(t.data[3*a],t.data[3*a+1],t.data[3*a+2]);l>o&&([r,o]=[a,l])}return r}function $A({tool:i,force:t},e,n){let s=new A().fromArray(t.data,3*e),r=Math.min(My.most,Math.max(My.least,VA*s.length())),o=new A().fromArray(i.data,7*e),a=s.normalize(),l=o.clone().addScaledVector(a,r),c=new A(Math.abs(a.x)<.7?1:0,Math.abs(a.x)<.7?0:1,0).cross(a).normalize(),u=[c,c.clone().negate(),a.clone().cross(c),c.clone().cross(a)].flatMap(f=>[...l.toArray(),...l.clone().addScaledVector(a,-Sy).addScaledVector(f,.5*Sy).toArray()]),d=[...o.toArray(),...l.toArray()];return[...n?Uh(d,Zf):d,...u]}var ku=class{group=new te;points=new ni(new Ft,yn(new Wn({size:GA,sizeAttenuation:!1,vertexColors:!0,map:Qh(),alphaTest:.3,transparent:!0}),.985));arrows=new to(4,[]);key="";starts=[];pushes=[];constructor(){this.points.frustumCulled=!1,this.points.renderOrder=7,this.group.add(this.points,this.arrows.line)}show(t,e,n,s,r){let o=`${e.start} ${e.number} ${t.happenings.length} ${e.count>0} ${r}`;o!==this.key&&(this.key=o,this.arrows.paint(zp.map(l=>new Mt(gt(l)))),this.build(t,e));let a=this.starts.filter(l=>l<=n).length;this.points.visible=s&&a>0,this.points.geometry.setDrawRange(0,a),this.arrows.show(s?this.pushes.filter(l=>l<=n).length:0)}build(t,e){let n=[],s=[];this.starts=[],this.pushes=[],this.arrows.clear();for(let r of t.happenings){let[o,a]=[r.start-e.start,r.end-e.start];if(o<0||o>e.length||r.source==="push"&&t.happenings.some(f=>f.source==="event"&&f.start<r.end&&f.end>r.start))continue;let c=e.toolAt((o+a)/2);if(!c)continue;let h=Bp(r);this.starts.push(o),n.push(c[0],c[1],c[2]),s.push(...new Mt(gt(h)).toArray());let u=zp.includes(h)?WA(e,o,a):-1;if(u<0)continue;let d=$A(e,u,r.source==="push");for(let f=0;f<d.length;f+=6)this.arrows.push(d.slice(f,f+6),zp.indexOf(h)),this.pushes.push(o)}this.points.geometry.dispose(),this.points.geometry=new Ft,this.points.geometry.setAttribute("position",new Vt(n,3)),this.points.geometry.setAttribute("color",new Vt(s,3))}};var XA=null;function Js(){return XA??=qA()}function qA(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!0;let t=i.getExtension("WEBGL_debug_renderer_info"),e=/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t?String(i.getParameter(t.UNMASKED_RENDERER_WEBGL)):"");return i.getExtension("WEBGL_lose_context")?.loseContext(),e}var YA=26e5,Ty=[.75,.6,.5],ZA=1.5,jA=700,KA=70,JA=6,Ou=class{software=Js();renderer;width=0;height=0;ratio=0;coarse=0;moved={last:0,took:0,frames:0};rest;constructor(t){this.renderer=new Rh({canvas:t,antialias:!this.software,alpha:!this.software,powerPreference:"high-performance"}),this.renderer.debug.checkShaderErrors=!1,this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Fs,this.renderer.shadowMap.autoUpdate=!this.software}hasShadows(t){return!this.software||t}get shadowSize(){return this.software?512:1024}size(t,e){[this.width,this.height,this.ratio]=[t,e,0]}paint(){this.software&&this.renderer.setClearColor(new Mt(gt("scene")))}draw(t,e,n,s){clearTimeout(this.rest),this.software&&!n&&this.keepUp(performance.now()),this.sharpen(n),this.renderer.shadowMap.needsUpdate=n,this.renderer.render(t,e),n||(this.rest=setTimeout(s,jA))}destroy(){clearTimeout(this.rest),this.renderer.dispose(),this.renderer.forceContextLoss()}keepUp(t){let{moved:e}=this,n=t-e.last;e.last=t,!(n>500)&&(e.took+=n,!(++e.frames<JA)&&(e.took/e.frames>KA&&this.coarse+1<Ty.length&&this.coarse++,e.took=e.frames=0))}sharpen(t){let e=Math.sqrt(YA/(this.width*this.height)),n=Math.min(devicePixelRatio||1,2,Math.max(1,e)),s=this.software?t?Math.min(Math.max(ZA,n),e):Ty[this.coarse]:n;s!==this.ratio&&(this.ratio=s,this.renderer.setPixelRatio(s),this.renderer.setSize(this.width,this.height,!1))}};var Bu=class{group=new te;looks=["paper","rejected"].map((t,e)=>Object.assign(new He({linewidth:4-2*e,polygonOffset:!0,polygonOffsetFactor:-7-e,polygonOffsetUnits:-7-e}),{name:t}));shown=null;constructor(){this.group.matrixAutoUpdate=!1,this.paint()}get count(){return this.group.visible?this.shown?.length??0:0}show(t,{pose:e,shape:n}){if(this.group.visible=t!==null,!t||t===this.shown)return;this.shown=t;for(let r of this.group.children)r.geometry.dispose();this.group.clear(),ce(e,this.group.matrix),this.group.matrixWorldNeedsUpdate=!0;let s=t.flatMap(r=>xs(gs(n,eo(r,2.5*Sn),!1),!1));this.group.add(...this.looks.map(r=>qn(s,r)))}paint(){for(let t of this.looks)t.color.set(gt(t.name))}},Fu=.03,Ey=.006,Uu=[.003,.004,.005],QA=.045;function Ay(i){let t=new Ni().absarc(0,0,i,Math.PI/4,7*Math.PI/4,!1);return new Os(t.lineTo(1.9*i,0),10)}function tR(i){let t=document.createElement("canvas");t.width=t.height=64;let e=t.getContext("2d");return e.arc(32,32,30,0,2*Math.PI),e.fillStyle=gt("ink"),e.fill(),e.font="bold 38px system-ui, sans-serif",e.textAlign="center",e.textBaseline="middle",e.fillStyle=gt("paper"),e.fillText(String(i),32,35),new Li(t)}var zu=class{group=new te;shown=null;theme="";get places(){return this.group.visible?this.shown?.poses.map(([t,e])=>new A(t,e,0))??[]:[]}show(t,e){if(this.group.visible=t!==void 0,!t||this.shown===t&&this.theme===e)return;[this.shown,this.theme]=[t,e],this.clear();let{poses:n,chosen:s}=t,r=Array.from({length:uo},(h,u)=>new Mt(gt(`band-${u+1}`))),o=this.addMarks(Ay(Fu+Ey),n.length),a=this.addMarks(Ay(Fu),n.length),l=s.map(h=>n[h]).filter(h=>h!==void 0),c=this.addMarks(new ks(2*Fu,2*Fu+2*Ey,32),l.length);c.material.depthTest=!1,c.renderOrder=8,n.forEach((h,u)=>{o.setMatrixAt(u,Gp(h,Uu[0])),o.setColorAt(u,new Mt(gt("quiet"))),a.setMatrixAt(u,Gp(h,Uu[1])),a.setColorAt(u,r[Zx(h[3])])}),l.forEach((h,u)=>{c.setMatrixAt(u,Gp(h,Uu[2])),c.setColorAt(u,new Mt(gt("ink")));let d=new Fr(new Or({map:tR(u+1),sizeAttenuation:!1,depthTest:!1}));d.position.set(h[0],h[1],Uu[2]),d.center.set(.5,-.6),d.scale.setScalar(QA),d.renderOrder=9,this.group.add(d)})}addMarks(t,e){let n=new Ko(t,yn(new ln({toneMapped:!1,transparent:!0}),.998),e);return n.frustumCulled=!1,this.group.add(n),n}clear(){for(let t of this.group.children)t instanceof Fr?t.material.map?.dispose():(t.dispose(),t.geometry.dispose()),t.material.dispose();this.group.clear()}},eR=new A(0,0,1),Gp=([i,t,e],n)=>new Lt().compose(new A(i,t,n),new Le().setFromAxisAngle(eR,e),new A(1,1,1));var Ry=5,Cy=1.5,il=.07,nR=.01,Gu=class{constructor(t,e,n){this.recording=t;this.robot=e;this.still=n;n.group.updateMatrixWorld(!0)}recording;robot;still;direction=null;get from(){let{count:t,over:e}=this.still.round;return(!this.direction||!e&&this.direction.samples!==t)&&(this.direction={samples:t,from:this.findDirection()}),this.direction.from}all(t){return this.move(t),iR(Xs([...this.robot?[this.robot.group]:[],this.still.bodies]))}surface(){let t=this.surfaceCorners;if(!t.length)return this.all(0);let e=this.contacts.flatMap(n=>(this.move(n),this.robot?Xs([this.robot.tool]):[]));return[...t,...e]}at(t){let{round:e}=this.still,n=e.plan.phases.filter(({contact:d})=>d),s=n.findIndex(({end:d})=>d>t),[r,o]=[n.at(s<0?-1:s-1),s<0?void 0:n[s]],a=s===0?0:r?.end??0,l=o?.start??e.length,c=(a+l)/2;if(o&&t>=Math.max(l-Cy,Math.min(c,l)))return this.stroke(o);if(r&&s!==0&&t<Math.min(a+Cy,c))return this.stroke(r);let h=[a,c,l].filter(d=>e.over||d<=e.t.last),u=[r,o].flatMap(d=>d?Py(e,d):[]);return{key:`${e.number} free ${a}`,points:[...(h.length?h:[t]).flatMap(d=>this.all(d)),...u]}}stroke(t){let e=Py(this.still.round,t);return{key:`${this.still.round.number} stroke ${t.start}`,points:e.length?e:this.surface()}}get surfaceCorners(){return this.still.surface?Xs([this.still.surface]):[]}get contacts(){let{count:t,t:e,plan:n}=this.still.round,s=n.phases.filter(({contact:o,end:a})=>o&&t>0&&a<=e.last).map(({start:o,end:a})=>(o+a)/2),r=Math.max(1,s.length/Ry);return Array.from({length:Math.min(Ry,s.length)},(o,a)=>s[Math.floor(a*r)])}move(t){let{round:e}=this.still,n=this.recording.at(e.start+Math.min(t,e.length));n&&this.robot&&(this.robot.show(e.plan.root,n.q,n.tool),this.robot.group.updateMatrixWorld(!0))}findDirection(){let{plan:t}=this.still.round,e=this.contacts.map(l=>(this.move(l),{blocks:this.robot?Gh(this.robot.links):[],tool:this.robot?[this.robot.toolPlace,...Xs([this.robot.tool])]:[]})),n=this.surfaceCorners,s=Vh(n),r=ms(t.surface,s),o=[s,...n.map(l=>l.clone().lerp(s,.15))].map(l=>l.clone().addScaledVector(r,nR)),a=this.robot&&e.length?s.clone().sub(this.robot.rootPlace):new A(.75,-1,0);return a.setZ(0).length()<.001&&a.set(1,0,0),lx(e,o,r,a.normalize().setZ(.6).normalize())}};function Py({plan:{strokes:i,surface:t}},{stroke:e}){let n=gs(t.shape,eo(i[e??-1]??[]),!1),s=ce(t.pose);return n.flatMap(r=>{let{x:o,y:a,z:l}=new A(...r).applyMatrix4(s);return Array.from({length:8},(c,h)=>new A(o+(h&1?il:-il),a+(h&2?il:-il),l+(h&4?il:0)))})}var iR=i=>i.length?i:[new A(-.5,-.5,0),new A(.5,.5,.5)];var Hu={believed:!0,estimated:!0,actual:!0,seen:!1,path:!0,ribbon:!0,strokes:!1,rejected:!0,bases:!1,force:!0,events:!0,found:!0,actualSurface:!0,collision:!1},sR=9,rR=6,Vp=new A(.9,.5,1.9),Iy=1.7,Ly=1.4,oR=Math.PI-Ly-Iy*Vp.z/Vp.length(),Vu=class{constructor(t,e,n){this.canvas=t;this.recording=e;this.left=n;this.painter=new Ou(t);let s=a=>this.painter.software?new Nn:new da({roughness:a,metalness:.05}),r=new Map,o=a=>{let[l,c,h,u]=a,d=r.get(a.join());if(d)return d;let f=Object.assign(s(.5),u<1?{depthWrite:!1}:{});return f.userData.opacity=u,f.color.setRGB(l,c,h,qe),this.clear(f),r.set(a.join(),f),f};this.materials={body:s(.6),arm:s(.5),joint:s(.45),ring:s(.4),handle:s(.4),collision:new ln({wireframe:!0,transparent:!0,opacity:.35}),tool:new Nn,coloured:o,own:r},this.scene.add(this.dirt.group,this.map.mesh,this.asked.group,this.force.group,this.marks.group,this.trajectories.group,this.axes.group,this.highlights,this.ghosts,this.rejected.group,this.bases.group),this.camera=new Iu(t,()=>this.ask(),()=>this.leave()),t.addEventListener("webglcontextrestored",()=>this.ask()),this.paint()}canvas;recording;left;layers={...Hu};camera;painter;scene=new qo;materials;seeThrough=0;ground=new ae(new Ns(1,1),new ua({opacity:.14}));sun=null;grid=null;robot=null;ghosts=new te;ghostList=[];still=null;path=null;shots=null;entered=new Map;highlighted=[];selected=null;highlights=new te;highlightLook=new He({linewidth:8,transparent:!0,opacity:.75,depthWrite:!1});trajectories=new nu;axes=new iu;dirt=new Kh;map=new Nu;asked=new wu;force=new Du;marks=new ku;rejected=new Bu;bases=new zu;choice=null;begun=!1;chosen=!1;shot=null;sized=!1;apply=()=>{};first=null;moved=()=>this.draw();time=0;drawn=0;onDrawn=null;get ghostCount(){return this.ghosts.children.length}get reasons(){return{stroke:this.chosenNow?.stroke??null,rejected:this.rejected.count,bases:this.bases.places.length}}show(t){this.time=t,this.ask()}ask(){Yn.draw(this.moved)}resize(t,e,n){if(!(!t||!e)){if(this.apply=()=>this.applySize(t,e,n),this.sized||!this.painter.software)return this.apply();this.first??=requestAnimationFrame(()=>setTimeout(()=>{this.canvas.isConnected&&this.apply()}))}}applySize(t,e,n){this.painter.size(t,e),this.camera.shape(t,e,n),this.chosen||(this.begun=!1),this.sized=!0,this.draw()}look(t){let e=this.recording.at(this.time);if(!this.shots||!e)return;this.shot=null,this.chosen=!0;let n=t==="all"?[...this.shots.all(e.time),...this.bases.places]:this.shots.surface();this.camera.look(Hh(n,t==="above"?new A(0,-.001,1):this.shots.from,this.camera.angles),!0),this.ask()}timeAt(t,e){if(!this.path||!(this.layers.path||this.layers.ribbon))return null;let{clientWidth:n,clientHeight:s}=this.canvas,r=this.path.nearest(o=>(o.project(this.camera.lens),{x:(o.x+1)/2*n,y:(1-o.y)/2*s}),t,e,this.time-this.path.round.start,sR,!this.layers.path);return r===null?null:this.path.round.start+r}get follow(){return this.shot!==null}set follow(t){this.shot=t?"":null,this.chosen=!0,this.ask()}set xray(t){this.seeThrough=t;let{body:e,arm:n,joint:s,ring:r,handle:o,own:a}=this.materials;for(let l of[e,n,s,r,o,...a.values()])this.clear(l);this.robot&&(this.robot.last=t>0),this.ask()}highlight(t){this.highlighted=t.map(({start:e,end:n})=>({from:e,to:n})),this.drawHighlights(),this.ask()}choose(t){this.choice=t,this.ask()}get chosenNow(){return this.choice&&this.choice.round===this.still?.round?this.choice:null}select(t){this.selected=t,this.lightRibbon(),this.ask()}get ribbon(){return this.path?.ribbon.counts??{drawn:0,lit:0}}showTrajectories(t){this.trajectories.show(t),this.ask()}showParticles(t){this.asked.show(t),this.ask()}showFrames(t){this.axes.show(t),this.ask()}showGhosts(t){this.ghostList=t,this.ghosts.clear();let{head:e,meshes:n}=this.recording;if(e&&this.robot)for(let{time:s,color:r}of t){let o=this.recording.at(s);if(!o)continue;let a=dy();a.color.set(Hi(r,gt("ghost")));let l=new el(e,n,{body:a,arm:a,joint:a,ring:a,handle:a,collision:a,tool:a,coloured:()=>a},this.robot);l.show(o.round.plan.root,o.q,o.tool),this.ghosts.add(l.group)}this.ask()}paint(){let t=(c,h)=>c.color.set(gt(h)),{body:e,arm:n,joint:s,ring:r,handle:o,collision:a,tool:l}=this.materials;t(e,"body-1"),t(n,"arm-1"),t(s,"joint"),t(r,"ring"),t(o,"joint"),t(a,"quiet"),t(l,"tool"),this.painter.paint(),this.showGhosts(this.ghostList),this.highlightLook.color.set(gt("highlight")),this.grid&&this.grid.material.color.set(gt("rule")),this.dirt.paint(),this.asked.paint(),this.trajectories.paint(),this.force.paint(),this.rejected.paint();for(let{still:c,path:h}of this.entered.values())c.paint(),h.paint();this.ask()}picture(){return this.draw(!0),this.canvas.toDataURL("image/png")}destroy(){Yn.drop(this.moved),this.camera.controls.dispose();for(let{still:t,path:e}of this.entered.values())t.dispose(),e.dispose();this.painter.destroy()}draw(t=!this.painter.software){let e=this.recording.at(this.time);this.sized&&(e&&this.place(e),this.sun&&(this.sun.castShadow=this.ground.visible=this.painter.hasShadows(t)),this.painter.draw(this.scene,this.camera.lens,t,()=>this.draw(!0)),this.drawn++,this.onDrawn?.())}place(t){let{head:e,meshes:n}=this.recording,{round:s,time:r}=t;!this.robot&&e&&(this.robot=new el(e,n,this.materials),this.scene.add(this.robot.group),this.showGhosts(this.ghostList)),this.still?.round!==s&&this.enter(t),this.aim(r),this.robot?.show(s.plan.root,t.q,t.tool);let o=t.phase>=0?s.plan.phases[t.phase].stroke:null,a=this.chosenNow;this.rejected.show(this.layers.rejected&&a?.rejected?a.rejected.lines:null,s.plan.surface),this.bases.show(this.layers.bases?s.plan.bases:void 0,fs()),this.still.show({strokes:this.layers.strokes,found:this.layers.found,actual:this.layers.actualSurface},o,this.recording.foundAt(this.time),a?.stroke??null),this.robot&&(this.robot.collisionShown=this.layers.collision),this.still.fade(this.camera.lens.position),this.path.show(r,this.layers),this.dirt.show(this.recording,this.time,t,this.layers,this.camera.pixelsPerMetre(this.still.surface,this.canvas.clientHeight)),this.map.show(Zh(this.recording,this.time,s,this.layers),fs()),this.marks.show(this.recording,s,r,this.layers.events,fs()),this.robot&&this.force.show(t,this.robot.toolPlace,this.camera.lens.position,this.layers.force)}enter({round:t}){for(let n of[this.still?.group,this.path?.object])n&&this.scene.remove(n);let e=this.entered.get(t)??this.make(t);this.entered.delete(t),this.entered.set(t,e);for(let[n,{still:s,path:r}]of this.entered){if(this.entered.size<=rR)break;this.entered.delete(n),s.dispose(),r.dispose()}this.still=e.still,this.path=e.path,this.shots=e.shots,this.scene.add(this.still.group,this.path.object),this.drawHighlights(),this.lightRibbon()}make(t){let e=new Wh(t,this.recording);return{still:e,path:new eu(t),shots:new Gu(this.recording,this.robot,e)}}aim(t){let{shots:e}=this;if(e){if(this.begun||(this.begun=!0,this.camera.look(Hh(e.surface(),e.from,this.camera.angles)),this.grid||this.build(new Ne().setFromPoints(e.all(t)).getBoundingSphere(new an))),this.shot!==null){let{key:n,points:s}=e.at(t);n!==this.shot&&this.camera.look(Hh(s,e.from,this.camera.angles),!0),this.shot=n}this.camera.step()&&this.ask()}}leave(){this.chosen=!0,this.shot!==null&&(this.shot=null,this.left())}clear(t){let e=(t.userData.opacity??1)*(1-this.seeThrough);t.opacity=e,t.transparent=e<1}lightRibbon(){if(!this.path)return;let{start:t}=this.path.round;this.path.ribbon.select(this.selected&&[this.selected[0]-t,this.selected[1]-t])}drawHighlights(){for(let n of[...this.highlights.children])n.geometry.dispose(),this.highlights.remove(n);if(!this.path)return;let{start:t}=this.path.round,e=this.highlighted.flatMap(({from:n,to:s})=>this.path.between(n-t,s-t));e.length&&this.highlights.add(qn(e,this.highlightLook))}build({center:t,radius:e}){let n=2*Math.min(60,Math.max(6,Math.ceil(3*e)));this.grid=new wa(n/2,n),this.grid.rotation.x=Math.PI/2,this.grid.position.set(Math.round(t.x),Math.round(t.y),0),Object.assign(this.grid.material,{vertexColors:!1,transparent:!0,opacity:.7}),this.grid.material.color.set(gt("rule")),this.ground.scale.setScalar(n/2),this.ground.position.set(this.grid.position.x,this.grid.position.y,-.001),this.ground.receiveShadow=!0;let s=new ya(16777215,Iy);s.position.copy(t).addScaledVector(Vp,2*e),s.target.position.copy(t),this.sun=s,s.shadow.mapSize.set(this.painter.shadowSize,this.painter.shadowSize),s.shadow.bias=-5e-4,s.shadow.normalBias=.01,s.shadow.intensity=.4,s.shadow.radius=4,Object.assign(s.shadow.camera,{left:-1.4*e,right:1.4*e,top:1.4*e,bottom:-1.4*e,near:.1,far:9*e});let r=new ma(16777215,9080728,Ly);r.position.set(0,0,1),this.scene.add(this.grid,this.ground,s,s.target,r,new va(16777215,oR));for(let[o,a]of[[[1,0,0],"axis-x"],[[0,1,0],"axis-y"],[[0,0,1],"axis-z"]]){let l=new He({linewidth:2.5});l.color.set(gt(a)),this.scene.add(qn([0,0,.002,...o.map(c=>.25*c)],l))}}};var aR={believed:"Believed and predicted dirt",estimated:"Estimated dirt after the round",actual:"True dirt after the round",seen:"Observed dirt",path:"Tool path",ribbon:"Force along the path",strokes:"Planned strokes",rejected:"Rejected plan, chosen in its table",bases:"Rated base poses",force:"Force",events:"Events, force at pushes",found:"Surface found by touch",actualSurface:"True surface",collision:"Collision shapes"},Wu=24,$u=class{constructor(t,e,n){this.recording=t;let s=_("canvas",{class:"w-canvas",tabindex:0,role:"application","aria-label":"Robot, tool and surface in 3-D. W A S D turn the scene, Z and X zoom."});this.stage=lR(s,t,()=>this.follow.setAttribute("aria-pressed","false"));let r=(f,p,x)=>_("button",{class:"w-button",type:"button",title:p,click:x},f);this.follow=r("Follow","Follow the work: wide in free motion, close at strokes  T",()=>this.toggleFollow()),this.follow.setAttribute("aria-pressed","false");let o=_("input",{type:"range",min:0,max:.95,step:.05,value:0,"aria-label":"Transparency of the robot",input:()=>{this.stage&&(this.stage.xray=Number(o.value))}}),a=_("div",{class:"w-views",role:"group","aria-label":"View"},r("Fit","Show all of robot and surface  F",()=>this.look("all")),r("Surface","Close view of the surface",()=>this.look("surface")),r("Above","View from above  V",()=>this.look("above")),this.follow,_("label",{class:"w-button w-xray",title:"Look through the robot"},"X-ray",o));if(this.element=_("section",{class:"w-scene","aria-label":"Scene"},this.stage?s:_("p",{class:"w-none"},"This browser cannot draw 3-D graphics. The other panels still work."),this.stage&&a,this.stage&&this.legend(e),_("div",{class:"w-scene-scale"},this.forceScale,this.reach,this.mapScale),this.extra,this.point,this.still),!this.stage)return;let{stage:l}=this,c=!1,h=()=>{let{clientWidth:f,clientHeight:p}=s,x=this.element.querySelector(".w-layers");!c&&f&&f<=640&&x&&(x.open=!1),c||=f>0,l.resize(f,p,x?.open&&f>640?x.offsetWidth:0)},u=new ResizeObserver(h);u.observe(s),this.element.addEventListener("toggle",h,!0);let d={x:0,y:0};s.addEventListener("pointerdown",({offsetX:f,offsetY:p})=>{d={x:f,y:p}}),s.addEventListener("click",({offsetX:f,offsetY:p})=>{if(Math.hypot(f-d.x,p-d.y)>3)return;let x=l.timeAt(f,p);x!==null&&n(x)}),s.addEventListener("pointermove",({offsetX:f,offsetY:p,buttons:x})=>this.explain(x?null:[f,p])),s.addEventListener("pointerleave",()=>this.explain(null)),this.stop.push(()=>u.disconnect(),ps(()=>{l.paint(),Qr()&&(this.still.src=l.picture())}))}recording;element;stage;boxes=new Map;extra=_("ul",{class:"w-named"});follow;still=_("img",{class:"w-still",alt:"The robot and the surface at the shown time"});stop=[];mapTitle=_("strong");mapScale=_("div",{class:"w-map-scale",hidden:!0},this.mapTitle);forceTitle=_("strong");forceScale=_("div",{class:"w-force-scale",hidden:!0},this.forceTitle,_("ul",{},...io.map(({colour:t,label:e})=>_("li",{},_("i",{"aria-hidden":"true",style:`background:var(--${t})`}),e))));point=_("div",{class:"w-point",hidden:!0});reach=jx();queried=[];rejected=null;scaleOf=null;treats=!1;version=-1;time=0;show(t){if(this.stage?.show(t),this.time=t,this.showScale(),this.version===this.recording.version)return;this.version=this.recording.version;let{rounds:e,observedBefore:n,head:s}=this.recording,r=s?.robot,o={believed:e.some(c=>bn(c)?c.treated!==null:c.plan.particles.length>0),estimated:e.some(c=>(bn(c)?c.interpreted?.treated:c.interpreted)!=null),actual:e.some(c=>(bn(c)?c.truth?.treated:c.truth?.particles)!=null),seen:n!==null||e.some(({observed:c})=>c!==null),path:e.some(({count:c})=>c>0),ribbon:e.some(({count:c})=>c>0),strokes:e.some(({plan:c})=>c.strokes.length>0),rejected:e.some(({plan:c})=>c.another||c.considered?.some(({lines:h})=>h?.length)),bases:e.some(({plan:c})=>c.bases?.poses.length),force:e.some(({count:c})=>c>0),events:this.recording.happenings.length>0,found:e.some(({interpreted:c})=>c?.found!=null),collision:r?.links.some(c=>Op(c).length>0)??!1,actualSurface:e.some(({truth:c})=>c?.surface!=null)};r&&kp(r)&&this.boxes.get("collision")?.querySelector("label").replaceChildren(ao("collision"),"Collision shapes (the robot's shell is drawn from them)");let a=e.find(bn);this.stage&&a&&!this.treats&&this.nameMaps(a),this.element.toggleAttribute("data-target",e.some(({target:c})=>c!==null));for(let[c,h]of this.boxes)h.hidden=!o[c];let l=this.element.querySelector(".w-layers");l&&(l.hidden=!Object.values(o).some(Boolean))}explain(t){let e=t&&this.stage.timeAt(...t),n=e===null?null:this.recording.at(e);if(this.point.hidden=n?.normal==null,!t||n?.normal==null)return;let{normal:s,height:r,round:o}=n,a=o.isPressed(n.time)?o.target:null;zt(this.point,[`${Gt(s,1)} N${a===null?"":`, ${Ct(s/a)} of the target of ${Gt(a,1)} N`}`,r===null?"":`height ${Gt(1e3*r,1)} mm`,`${oe(e,2)} (click to go there)`].filter(f=>f).join(`
`));let[l,c]=t,{offsetWidth:h,offsetHeight:u}=this.point,d=l+h+Wu>this.element.clientWidth;Object.assign(this.point.style,{left:`${d?l-h-Wu:l+Wu}px`,top:`${Math.max(2,c-u-Wu)}px`})}showScale(){let t=this.stage&&this.recording.roundAt(this.time);this.forceScale.hidden=!t?.target||!t.count||!this.stage.layers.ribbon,t?.target&&zt(this.forceTitle,`Force along the path, target ${Gt(t.target,1)}\u202FN`);let e=t&&Zh(this.recording,this.time,t,this.stage.layers);this.reach.hidden=!t?.plan.bases||!this.stage.layers.bases,this.mapScale.hidden=!e,e&&(zt(this.mapTitle,e.title),this.scaleOf!==e.record&&(this.scaleOf=e.record,this.mapScale.replaceChildren(this.mapTitle,Za(e.record))))}nameMaps(t){this.treats=!0;let e=_i(t),n={believed:`Predicted ${e}`,estimated:`Estimated ${e} after the round`,actual:`True ${e} after the round`};for(let[s,r]of Object.entries(n))this.boxes.get(s)?.querySelector("label").replaceChildren(ao("map"),r);for(let s of["actual","ribbon"])this.stage.layers[s]=!1,this.boxes.get(s).querySelector("input").checked=!1}look(t){this.follow.setAttribute("aria-pressed","false"),this.stage?.look(t)}toggleFollow(){this.stage&&(this.stage.follow=!this.stage.follow,this.follow.setAttribute("aria-pressed",String(this.stage.follow)))}name(t){this.queried=t,this.listNamed()}choose(t){this.rejected=t?.rejected?.name??null,this.stage?.choose(t),this.listNamed()}listNamed(){let t=this.rejected!==null&&this.stage?.layers.rejected?[{name:this.rejected,colour:"var(--rejected)"}]:[];this.extra.replaceChildren(...[...t,...this.queried].map(({name:e,colour:n,form:s})=>{if(s)return _("li",{},Nx(n,s==="estimated"),e);let r=_("i",{"aria-hidden":"true"});return r.style.background=n,_("li",{},r,e)}))}destroy(){for(let t of this.stop)t();this.stage?.destroy()}legend(t){let e=Object.keys(Hu).map(n=>{let s=ji(),r=_("input",{type:"checkbox",id:s,checked:Hu[n],change:()=>{this.stage&&(this.stage.layers[n]=r.checked,this.stage.ask(),this.showScale(),this.listNamed())}}),o=_("li",{},r,_("label",{for:s},ao(n),aR[n]));return this.boxes.set(n,o),o});return _("details",{class:"w-layers",open:!t},_("summary",{},"Layers"),_("ul",{},...e))}};function lR(i,t,e){try{return new Vu(i,t,e)}catch{return null}}var cR=170,Hp=15,Dy=8,Wp=3,hR=3;function uR(i,t,e){let n=({label:l,count:c})=>Math.min(cR,t(Ny(l,c))),s=[],r=new Map;for(let{x:l,label:c}of[...i].sort((h,u)=>h.x-u.x)){let h=r.get(c);if(h&&l<h.x+n(h)+Dy){h.count++;continue}let u={x:l,label:c,count:1};s.push(u),r.set(c,u)}let o=Array.from({length:hR},()=>-1/0),a=[];for(let l of s){let c=n(l),h=Math.min(l.x,e-c),u=o.findIndex(d=>d+Dy<=h);u<0||(o[u]=h+c,a.push({text:Ny(l.label,l.count),x:h,width:c,row:u}))}return a}var Ny=(i,t)=>t>1?`${i} \xD7${t}`:i;function ky(i,t,e){let n=t.lane("rounds")?.top??0,s=t.width-t.right,r=[];i.fillStyle=gt("highlight");for(let{start:o,end:a,label:l}of e){if(a<t.from||o>t.to)continue;let c=Math.max(t.left,t.x(o)),h=Math.max(c+2,Math.min(s,t.x(a)));i.globalAlpha=.28,i.fillRect(c,n,h-c,t.height-n),i.globalAlpha=1,i.fillRect(c,n-3,h-c,3),l&&r.push({x:c+Wp,label:l})}ai(i,10,600),i.textAlign="left",i.textBaseline="middle";for(let{text:o,x:a,width:l,row:c}of uR(r,h=>i.measureText(h).width,s)){let h=t.height-4-(c+.5)*Hp;i.globalAlpha=.85,i.fillStyle=gt("paper"),i.beginPath(),i.roundRect(a-Wp,h-Hp/2+1,l+2*Wp,Hp-2,3),i.fill(),i.globalAlpha=1,i.fillStyle=gt("ink"),$s(i,o,a,h+.5,l+1)}}function Oy(i,t,{top:e,height:n},[s,r]){let o=t.width-t.right,[a,l]=[s,r].map(c=>Math.min(o,Math.max(t.left,t.x(c))));i.fillStyle=gt("paper"),i.globalAlpha=.65,i.fillRect(t.left,e-2,a-t.left,n+4),i.fillRect(l,e-2,o-l,n+4),i.globalAlpha=1,i.strokeStyle=gt("accent"),i.lineWidth=1.5,i.strokeRect(a,e-1,l-a,n+2)}function Fy(i,t,e,n,s,r,o){let a=l=>e.top+e.height-(l-n)/(s-n)*e.height;ai(i,10),i.textAlign="right",i.textBaseline="middle";for(let l of rx(n,s,r))Je(i,t.left,a(l),t.width-t.right,a(l),Math.abs(l)<1e-12?"rule":"grid"),i.fillStyle=gt("quiet"),i.fillText(o(l),t.left-5,Math.min(Math.max(a(l),e.top+4),e.top+e.height-3));return a}function Uy(i,t,e,n){i.save(),i.beginPath(),i.rect(t.left-1,e.top-2,t.span+2,e.height+4),i.clip(),n(),i.restore()}function $p(i,t,e,n,s,r){let[o,a]=[0,r.least];for(let u of n.rounds){let{least:d,largest:f}=s(u);d<=f&&([o,a]=[Math.min(o,d*r.unit),Math.max(a,f*r.unit,r.target?.(u)??0)])}r.bounds&&([o,a]=[Math.max(o,r.bounds[0]),Math.min(a,r.bounds[1])]);let l=.06*(a-o),c=Fy(i,t,e,o<0?o-l:0,a+l,3,u=>String(Number(u.toPrecision(3))).replace("-","\u2212")),h=null;Uy(i,t,e,()=>{for(let u of n.rounds){if(u.end<t.from||u.start>t.to||!u.count)continue;let d=r.target?.(u)??null;d!==null&&zy(i,[Math.max(t.left,t.x(u.start)),t.x(u.end)],c(d),t.narrow||d===h?"":`target ${Gt(d,1)}\u202FN`,!0),h=d,i.strokeStyle=gt(r.name),i.lineWidth=1.5,i.lineJoin="round",i.beginPath();let f=s(u);u.count*((t.to-t.from)/Math.max(u.length,1e-9))>4*t.span?fR(i,t,u,f,x=>c(x*r.unit)):dR(i,t,u,f,x=>c(x*r.unit)),i.stroke()}})}function dR(i,t,e,n,s){let r=e.place(t.from-e.start)[0],o=Math.min(e.count,e.place(t.to-e.start)[0]+2),a=!1;for(let l=r;l<o;l++){let c=n.data[l];if(!Number.isFinite(c)){a=!1;continue}let h=t.x(e.start+e.t.data[l]);a?i.lineTo(h,s(c)):i.moveTo(h,s(c)),a=!0}}function fR(i,t,e,n,s){let r=!1;_y(t,e,(o,a,l)=>{let c=n.range(a,l+1);if(!c){r=!1;return}let[h,u]=[s(c[1]),s(c[0])];r?i.lineTo(o,u):i.moveTo(o,u),i.lineTo(o,u-h<.7?u-.7:h),r=!0})}var pR=14;function By(i,t,e,n){let s=Fy(i,t,e,0,1,2,a=>String(Math.round(100*a))),r=n.head?.task?.target,o=t.width-t.right;Uy(i,t,e,()=>{r!==void 0&&zy(i,[t.left,o],s(r),`target ${Math.round(100*r)}\u202F%`,r<=.8);for(let a of n.rounds)a.end<t.from||a.start>t.to||mR(i,t,a,s)}),n.rounds.forEach((a,l)=>{if(!a.interpreted||a.end>t.to+1e-9)return;let c=gR(t,a,n.rounds[l+1]);c&&xR(i,c,a.interpreted.estimate,s),a.end>=t.from&&yR(i,t,a,s)})}function zy(i,[t,e],n,s,r){i.setLineDash([6,4]),Je(i,t,n,e,n,"target",1.5),i.setLineDash([]),ai(i,10),i.fillStyle=gt("target"),i.textAlign="left",i.textBaseline=r?"bottom":"top",i.fillText(s,t+5,n+(r?-2:3))}function mR(i,t,e,n){let s=e.plan.growth;if(!s.length)return;i.strokeStyle=gt("believed"),i.lineWidth=2.2,i.lineCap="round",i.setLineDash(sx),i.beginPath(),s.forEach(([o,a],l)=>{let c=t.x(e.start+Math.min(o,e.length));l?i.lineTo(c,n(a)):i.moveTo(c,n(a))});let r=s.at(-1);r[0]<e.length&&i.lineTo(t.x(e.end),n(r[1])),i.stroke(),i.setLineDash([]),i.lineCap="butt"}function gR(i,t,e){let n=i.x(t.end),s=e?i.x(e.start+e.firstContact):0,[r,o]=[Math.max(n,i.left),Math.min(Math.max(n+pR,s),i.width-4)];return o>r?[r,o]:null}function xR(i,[t,e],{mean:n,low:s,high:r},o){i.fillStyle=gt("interval"),i.fillRect(t,o(r),e-t,Math.max(1,o(s)-o(r)));for(let a of[s,r])Je(i,t,o(a),e,o(a),"estimated",1);Je(i,t,o(n),e,o(n),"estimated",2.4)}function yR(i,t,e,n){let{estimate:s,by_touch:r}=e.interpreted,o=t.x(e.end),a=e.growthAt(e.length);a!==null&&vR(i,o,n(a),n(s.mean)),(r.low!==s.low||r.high!==s.high)&&bR(i,o-13,n,r,"by-touch",1.4,3);let l=e.truth?.performance??null;if(l===null)return;let c=n(l);for(let[h,u]of[[5,"paper"],[2.4,"actual"]])Je(i,o+3,c-4.5,o+12,c+4.5,u,h),Je(i,o+12,c-4.5,o+3,c+4.5,u,h)}function vR(i,t,e,n){if(Je(i,t,e,t,n,"ink",1.4),Math.abs(n-e)<8)return;let s=6*Math.sign(e-n);Je(i,t-3.5,n+s,t,n,"ink",1.4),Je(i,t+3.5,n+s,t,n,"ink",1.4)}function bR(i,t,e,{mean:n,low:s,high:r},o,a,l){Je(i,t,e(s),t,e(r),o,a),Je(i,t-l,e(s),t+l,e(s),o,a),Je(i,t-l,e(r),t+l,e(r),o,a),i.fillStyle=gt(o),i.beginPath(),i.arc(t,e(n),1.7*a,0,2*Math.PI),i.fill()}function Gy(i,t){let e=new Map,n=!1,s=null,r=l=>{let{left:c,width:h}=i.getBoundingClientRect();return(l.clientX-c)*(i.clientWidth/h||1)},o=()=>{let[l=0,c=0]=[...e.values()];return{middle:(l+c)/2,distance:Math.max(10,Math.abs(l-c))}};i.addEventListener("pointerdown",l=>{if(!(l.button!==0||l.target instanceof HTMLButtonElement))if(e.set(l.pointerId,r(l)),i.setPointerCapture(l.pointerId),i.focus({preventScroll:!0}),e.size===1){n=!1;let{top:c,height:h}=i.getBoundingClientRect();s=l.pointerType!=="touch"&&t.selectsAt((l.clientY-c)*(i.clientHeight/h||1))?r(l):null,t.select(null),t.seek(r(l))}else n=!0}),i.addEventListener("pointermove",l=>{if(!e.has(l.pointerId)){t.hover(r(l));return}let c=o();if(e.set(l.pointerId,r(l)),e.size===2){let h=o();t.zoom(c.middle,c.distance/h.distance,h.middle-c.middle)}else n||(s===null?t.seek(r(l)):Math.abs(r(l)-s)>4&&t.select([s,r(l)]),t.hover(r(l)))});let a=l=>{e.delete(l.pointerId),l.pointerType!=="mouse"&&t.hover(null)};i.addEventListener("pointerup",a),i.addEventListener("pointercancel",a),i.addEventListener("pointerleave",()=>t.hover(null)),i.addEventListener("dblclick",()=>t.reset()),i.addEventListener("wheel",l=>{let{scrollHeight:c,clientHeight:h}=document.documentElement,u=Math.abs(l.deltaX)>Math.abs(l.deltaY)||l.shiftKey;if(!(l.ctrlKey||u||i.contains(document.activeElement)||c<=h+1))return;l.preventDefault();let f=l.shiftKey&&!l.deltaX?l.deltaY:u?l.deltaX:l.deltaY;u?t.zoom(r(l),1,-f):t.zoom(r(l),Math.exp(Math.max(-1,Math.min(1,f*.002))),0)},{passive:!1})}var _R=["axis","rounds","phases","contact","events","force","height","performance"],wR=["axis","rounds","phases","contact","events","force"],MR=[-20,80],SR=700,Vy=700,Hy={card:60,software:250},Wy=.2,Xu=class{constructor(t,e,n,s){this.recording=t;this.clock=e;this.selected=s;this.frame=new Bh(n?wR:_R),this.element=_("div",{class:"w-timeline",role:"slider",tabindex:0,"aria-label":"Time in the run","aria-valuemin":0,"aria-keyshortcuts":"Space ArrowLeft ArrowRight [ ] Home End"},this.base,this.veil,this.hair,this.cursor,this.whole,this.tip),Gy(this.element,{seek:o=>{e.playing&&e.pause(),e.seek(this.timeAt(o))},selectsAt:o=>{let a=this.frame.lane("force");return a!==void 0&&o>=a.top&&o<=a.top+a.height},select:o=>this.select(o&&[this.timeAt(Math.min(...o)),this.timeAt(Math.max(...o))]),hover:o=>this.hover(o),zoom:(o,a,l)=>this.zoom(o,a,l),reset:()=>this.reset()});let r=new ResizeObserver(()=>this.resize());r.observe(this.element),requestAnimationFrame(()=>{let o=this.element.closest(".w-view");o&&r.observe(o)}),this.stop.push(()=>r.disconnect(),e.subscribe(()=>this.ask()),t.onChange(()=>this.ask()),ps(()=>this.resize()))}recording;clock;selected;element;base=_("canvas",{"aria-hidden":"true"});cursor=_("i",{class:"w-cursor","aria-hidden":"true"});hair=_("i",{class:"w-hair","aria-hidden":"true",hidden:!0});veil=_("i",{class:"w-veil","aria-hidden":"true",hidden:!0});whole=_("button",{class:"w-button w-whole",type:"button",hidden:!0,title:"Show the whole run  (double-click)",click:()=>this.reset()},"Whole run");tip=_("div",{class:"w-tip",hidden:!0});frame;stop=[];highlights=[];selection=null;zoomed=!1;drawn={version:-1,duration:-1,at:-1/0};later;moved=()=>this.draw();stale=!0;hovered=null;highlight(t){this.highlights=t,this.redraw()}timeAt(t){return this.frame.t(Math.min(Math.max(t,this.frame.left),this.frame.width-this.frame.right))}select(t){!t&&!this.selection||(this.selection=t,this.selected(t),this.redraw())}redraw(){this.stale=!0,this.ask()}destroy(){Yn.drop(this.moved),clearTimeout(this.later);for(let t of this.stop)t()}ask(){Yn.draw(this.moved)}resize(){let t=Qr()?SR:this.element.clientWidth;if(!t)return;this.frame.layOut(t,Qr()||(this.element.closest(".w-view")?.clientHeight??Vy)<Vy);let e=this.element.currentCSSZoom??1,n=Qr()?3:Math.min((devicePixelRatio||1)*e,2);this.base.width=Math.round(t*n),this.base.height=Math.round(this.frame.height*n),this.base.style.width=`${t}px`,this.base.style.height=`${this.frame.height}px`,this.element.style.height=`${this.frame.height}px`,this.stale=!0,Yn.drop(this.moved),this.draw()}reset(){this.zoomed=!1,this.redraw()}zoom(t,e,n){let{frame:s}=this,r=Math.max(this.clock.duration,Wy),o=s.t(t),a=Math.min(r,Math.max(Wy,(s.to-s.from)*e)),l=(o-s.from)/(s.to-s.from),c=o-l*a-n/s.span*a;c=Math.min(Math.max(0,c),r-a),[s.from,s.to]=[c,c+a],this.zoomed=a<r*.999,this.redraw()}pen(){let t=this.base.getContext("2d",{willReadFrequently:Js()}),e=this.base.width/(parseFloat(this.base.style.width)||1);return t.setTransform(e,0,0,e,0,0),t.clearRect(0,0,this.frame.width,this.frame.height),t}draw(){let{recording:t,clock:e,frame:n}=this,{duration:s}=e;this.zoomed?(e.playing||e.following)&&this.scrollToCursor():[n.from,n.to]=[0,Math.max(s,.001)],this.isDue()&&(this.drawBase(),this.drawn={version:t.version,duration:s,at:performance.now()},this.stale=!1),this.whole.hidden=!this.zoomed,this.moveOverlays();let{element:r}=this;r.setAttribute("aria-valuemax",s.toFixed(1)),r.setAttribute("aria-valuenow",e.time.toFixed(2));let o=t.at(e.time),a=o?.round.plan.phases[o.phase]?.name;r.setAttribute("aria-valuetext",`${oe(e.time)}${o?`, round ${o.round.number}`:""}${a?`, ${a}`:""}`)}isDue(){let{recording:t,clock:e,drawn:n}=this;if(this.stale||n.duration!==e.duration)return!0;if(n.version===t.version)return!1;let s=Js()?Hy.software:Hy.card,r=t.live?n.at+s-performance.now():0;return r<=0?!0:(clearTimeout(this.later),this.later=setTimeout(()=>this.ask(),r),!1)}scrollToCursor(){let{frame:t,clock:e}=this,n=t.to-t.from;if(e.time>=t.from&&e.time<=t.to-.03*n)return;let s=Math.min(Math.max(0,e.time-.1*n),Math.max(0,e.duration-n));Math.abs(s-t.from)<1e-9||([t.from,t.to]=[s,s+n],this.stale=!0)}drawBase(){let{frame:t,recording:e}=this,n=this.pen();for(let r of t.lanes){switch(r.name){case"axis":xy(n,t,r);break;case"rounds":yy(n,t,r,e);break;case"phases":vy(n,t,r,e);break;case"contact":by(n,t,r,e);break;case"events":wy(n,t,r,e);break;case"force":$p(n,t,r,e,a=>a.normal,{name:"force",unit:1,least:5,target:a=>a.target});break;case"height":$p(n,t,r,e,a=>a.height,{name:"height",unit:1e3,least:10,bounds:MR});break;case"performance":By(n,t,r,e);break}ai(n),n.fillStyle=gt("quiet"),n.textAlign="left",n.textBaseline="middle";let o=$f.has(r.name);t.narrow?o&&n.fillText(r.label,2,r.top-8):r.label.split(`
`).forEach((a,l)=>$s(n,a,2,r.top+(o?8+13*l:r.height/2),t.left-(o?26:6)))}ky(n,t,this.highlights);let s=t.lane("force");s&&this.selection&&Oy(n,t,s,this.selection),this.drawVeil()}moveOverlays(){let{frame:t,clock:e}=this,n=t.width-t.right,s=t.x(e.time);this.cursor.hidden=s<t.left-1||s>n+1,this.cursor.style.transform=`translateX(${s.toFixed(1)}px)`,this.hair.hidden=this.hovered===null,this.hovered!==null&&(this.hair.style.transform=`translateX(${this.hovered}px)`)}drawVeil(){let{frame:t,recording:e}=this,n=t.width-t.right,s=Math.min(n,Math.max(t.left,t.x(e.now)));this.veil.hidden=!e.live||s>=n,Object.assign(this.veil.style,{left:`${s}px`,width:`${n-s}px`})}hover(t){let{frame:e}=this,n=t!==null&&t>=e.left&&t<=e.width-e.right;this.hovered=n?t:null,this.tip.hidden=!n,n&&(zt(this.tip,this.describe(e.t(t)).join(`
`)),this.tip.style.left=`${Math.max(2,Math.min(t-this.tip.offsetWidth/2,e.width-this.tip.offsetWidth-2))}px`),this.ask()}describe(t){let e=this.recording.at(t);if(!e)return[oe(t,2)];let{round:n,normal:s,height:r,performance:o,phase:a,contact:l}=e,c=4*((this.frame.to-this.frame.from)/this.frame.span),h=this.recording.happenings.filter(({start:f,end:p})=>t>=f-c&&t<=p+c),u=this.highlights.filter(({start:f,end:p,label:x})=>x&&t>=f-c&&t<=p+c).map(({label:f})=>f),d=this.recording.rounds.findLast(f=>f.interpreted&&Math.abs(t-f.end)<4*c)??this.recording.resultAt(t);return[`${oe(t,2)} \xB7 round ${n.number}`,n.plan.phases[a]?.name??"",s===null?"":`force ${Gt(s,1)} N${l==="none"||n.target===null?"":`, target ${Gt(n.target,1)} N`}`,r===null?"":`height ${Gt(1e3*r,1)} mm`,l==="none"?"":l==="pushed"?`pushed by somebody or something${r!==null&&r>od?", not on the surface":""}`:"contact with the surface",o===null?"":`performance ${Ct(o)} predicted`,...d?TR(d):[],this.selection&&t>=this.selection[0]&&t<=this.selection[1]?ER(this.recording,this.selection):"",...new Set(u),...h.map(({kind:f,words:p})=>`${f}: ${p}`)].filter(f=>f!=="")}};function TR(i){let{estimate:t}=i.interpreted,e=i.growthAt(i.length);return[`performance after round ${i.number}: ${Xi(t)} estimated`,e===null?"":`the estimate after round ${i.number} replaces the prediction of ${Ct(e)}`,typeof i.truth?.performance=="number"?`true performance after round ${i.number}: ${Ct(i.truth.performance)}`:""]}function ER({rounds:i},[t,e]){let n=i.filter(o=>o.count&&o.start<=e&&o.end>=t).map(o=>o.normal.range(o.place(t-o.start)[0],o.place(e-o.start)[0]+1)).filter(o=>o!==null),[s,r]=[Math.min(...n.map(o=>o[0])),Math.max(...n.map(o=>o[1]))];return`selected: ${oe(t,2)} to ${oe(e,2)}${n.length?`, force ${Gt(s,1)} to ${Gt(r,1)} N`:""}`}function $y(i,t,e){let n=_("button",{class:"w-button w-play",type:"button",click:()=>i.toggle()}),s=u=>_("button",{class:"w-button w-icon",type:"button","aria-label":u<0?"Previous event or stroke":"Next event or stroke",title:u<0?"Previous event or stroke  [":"Next event or stroke  ]",click:()=>i.seek(bu(t.stops,i.time,u))},bp(u<0?"before":"after")),r=_("button",{class:"w-button w-live",type:"button",title:"Follow the live run  L",click:()=>i.follow()},"LIVE"),o=_("output",{class:"w-time","aria-live":"off"}),a=_("select",{class:"w-select","aria-label":"Playback speed",change:()=>i.setSpeed(Number(a.value))},...ro.map(u=>_("option",{value:u},`${u}\xD7`))),l=_("details",{class:"w-keys",name:"w-menu"},_("summary",{},"Keys"),_("dl",{},...Xx.flatMap(([u,d])=>[_("dt",{},u),_("dd",{},d)]))),c=null,h=()=>{let u=i.playing||i.following;u!==c&&(c=u,n.replaceChildren(bp(u?"pause":"play"),_("span",{},u?"Pause":"Play")),n.setAttribute("aria-label",u?"Pause":"Play")),r.hidden=!i.live,r.setAttribute("aria-pressed",String(i.following)),zt(o,`${oe(i.time)} / ${oe(i.duration)}${i.isLate?" (slower than real time)":""}`),Number(a.value)!==i.speed&&(a.value=String(i.speed))};return h(),{element:_("div",{class:"w-transport",role:"group","aria-label":"Playback"},n,s(-1),s(1),r,o,a,e,l),show:h}}var AR=150;function RR(i,t,e,n){return qx(i,t,e,s=>{if(s==="f")n.look("all");else if(s==="v")n.look("above");else if(s==="t")n.toggleFollow();else if(s==="l"&&t.live)t.follow();else return!1;return!0})}function sl(i,t,{compact:e=!1,clock:n}={}){let s=n??new oo,r=s.join(t),o=new $u(t,e,y=>{s.playing&&s.pause(),s.seek(y)}),a=new Xu(t,s,e,y=>o.stage?.select(y)),l=e?null:new gu(t,s,y=>o.choose(y)),c=o.stage&&!e?$x(o.stage,t,s):null,h=$y(s,t,c?.element??null),u=_("div",{class:`w-view${e?" w-compact":""}`},_("div",{class:"w-grid"},o.element,l?.element,_("div",{class:"w-below"},h.element,a.element)));i.append(u);let d=cu(Js()?AR:0,()=>{l?.show(),h.show(),c?.show()}),f=()=>{o.show(s.time),d.ask()},p=()=>Yn.draw(f),x=[r,s.subscribe(p),t.onChange(()=>{s.onGrowth(),p()}),ps(()=>g()),RR(u,s,t,o)];t.live&&s.follow(),f();let m={trajectories:[],ghosts:[],frames:[],particles:[]},g=()=>o.name([...m.trajectories.map(({name:y,color:E},D)=>({name:y,colour:su(E,D)})),...m.ghosts.map(({time:y,color:E})=>({name:`${t.head?.robot?"robot":"tool"} at ${oe(y)}`,colour:Hi(E,gt("ghost"))})),...m.frames.map(({name:y,color:E})=>({name:y,colour:Hi(E,gt("axis-z"))})),...m.particles.map(({name:y,color:E,state:D})=>({name:y,colour:_u(E),form:D}))]),v=y=>{m.trajectories=y,o.stage?.showTrajectories(y),g()},S=y=>{m.ghosts=y,o.stage?.showGhosts(y),g()},b=y=>{m.frames=y,o.stage?.showFrames(y),g()},T=y=>{m.particles=y,o.stage?.showParticles(y),g()},R=y=>{a.highlight(y),o.stage?.highlight(y)};return{element:u,clock:s,showTrajectories:v,showRobotAt:S,showFrames:b,showParticles:T,highlight:R,seek:y=>s.seek(y),clearShown:()=>{v([]),S([]),b([]),T([]),R([])},get frames(){return o.stage?.drawn??0},get ghosts(){return o.stage?.ghostCount??0},get reasons(){return o.stage?.reasons??null},get ribbon(){return o.stage?.ribbon??{drawn:0,lit:0}},camera:o.stage?.camera??null,destroy:()=>{Yn.drop(f),d.stop(),c?.destroy();for(let y of x)y();o.destroy(),a.destroy(),n||s.destroy(),u.remove()}}}function Xp(i){let t=new URLSearchParams(i.replace(/^#/,"")),e=Number.parseFloat(t.get("t")??""),n={time:Number.isFinite(e)&&e>=0?e:null,query:t.get("q")||null};for(let r of["episode","run"]){let o=t.get(r);if(o)return{kind:r,ids:[o],...n}}let s=(t.get("compare")??"").split(",").filter(r=>r);return s.length===2?{kind:"compare",ids:s,...n}:{kind:"home",ids:[],...n}}function ws({kind:i,ids:t,time:e,query:n}){let s=[];return i!=="home"&&s.push(`${i}=${t.map(encodeURIComponent).join(",")}`),e!==null&&i!=="home"&&s.push(`t=${e.toFixed(1)}`),n&&s.push(`q=${encodeURIComponent(n)}`),s.length?`#${s.join("&")}`:""}var Xy=(i,t)=>i.kind===t.kind&&i.ids.join()===t.ids.join();function qy(i){let t=ws(i);t!==location.hash&&history.replaceState(null,"",t||location.pathname)}var mo=["A","B"],CR=500,[Qs,qp,Yy]=[52,14,18],qu={force:96,performance:110},PR=30,rl=(i,t,e=1)=>n=>{let s=Gt(e*n,t);return`${n>0?"+":""}${s}${i&&`\u202F${i}`}`},Yu=rl("points",0,100);function IR({rounds:i}){if(!i.some(({count:e})=>e))return null;let t=0;for(let e of i){let{data:n}=e.tool;for(let s=1;s<e.count;s++){let r=Math.hypot(...[0,1,2].map(o=>n[7*s+o]-n[7*s-7+o]));Number.isFinite(r)&&e.contactAt(e.t.data[s])==="contact"&&(t+=r)}}return t}function LR({happenings:i}){let t=new Map;for(let{source:e,kind:n}of i)e==="event"&&t.set(n,(t.get(n)??0)+1);return[...t].map(([e,n])=>`${n} \xD7 ${e}`).join(", ")||"none"}function Zy(i){let{head:t,rounds:e,ended:n}=i,{state:s,text:r}=co(i),o=t?.task,a=e.flatMap(({plan:m})=>m.considered?.find(g=>g.chosen)?.strategy??[]),l=e.findLast(({interpreted:m})=>m)??e.at(-1),c=l?.interpreted,h=s==="unknown",u=l?.plan.predicted??null,d=l?.truth?.performance??null,f=Math.max(...e.map(({normal:m})=>m.largest)),p=IR(i),x=c?Xi(c.estimate,h?n.verdict:void 0):An;return[{label:"Task",text:o?`${o.action} on ${o.surface}`:An},{label:"Medium",text:o?.medium??An},{label:"Tool",text:o?.tool??An},{label:"Strategy",text:o?[o.strategy,...a.length?[`chosen: ${a.join(", ")}`]:[]].join("; "):An},{label:"Target",text:Xe(o?.target,Ct),value:o?.target??null,by:Yu},{label:"Rounds",text:String(e.length),value:e.length,by:rl("",0)},{label:"Predicted, last round",text:Xe(u,Ct),value:u,by:Yu},{label:"Estimated, last round",text:x,value:h?null:c?.estimate.mean??null,by:Yu},{label:"True, last round",text:Xe(d,Ct),value:d,by:Yu},{label:"Way in contact",text:Xe(p,m=>`${Gt(m,2)} m`),value:p,by:rl("m",2)},{label:"Duration",text:oe(i.duration),value:i.duration,by:rl("s",1)},{label:"Largest force",text:f>0?`${Gt(f,1)} N`:An,value:f>0?f:null,by:rl("N",1)},{label:"Events",text:LR(i)},{label:"Result",text:r}]}function DR(i,t){let e=Zy(t);return Zy(i).map(({label:n,text:s,value:r,by:o},a)=>{let l=e[a],c=typeof r=="number"&&typeof l.value=="number",h=(o?c:s!==An)?"":An;return{label:n,texts:[s,l.text],by:s===l.text?h:c?o(l.value-r):"differs"}})}function NR(i,t,e,n){return Array.from({length:n},(s,r)=>{let[o,a]=[r*e/n,(r+1)*e/n],l=i.roundAt(o);if(!l?.count||o>l.start+l.t.last)return null;let c=l.place(o-l.start)[0];return t(l).range(c,Math.max(c,l.place(a-l.start)[0])+1)})}var Yp=(i,t,e,n,s={})=>ot("text",{x:i,y:t,"text-anchor":n,"font-size":11,fill:"var(--quiet)",...s},e),jy=i=>i?{"stroke-width":1.2}:{"stroke-width":3,"stroke-opacity":.7},Ky=i=>`var(--${i?"second":"first"})`,Zu=class{constructor(t,e,n){this.pair=t;this.clock=n;let s=t.map(({head:l},c)=>_("li",{},Zp(c),[l?.title,e[c]].filter(h=>h).join(" \xB7 "))),r="Line: predicted performance. Bar and dot: estimate with its 90\u202F% interval after a round. Cross: true.";this.element=_("section",{class:"s-compare","aria-label":"Comparison"},_("div",{},_("ul",{class:"w-legend"},...s),this.plots,_("p",{class:"w-quiet s-remark"},r)),this.table);let o=cu(CR,()=>this.draw()),a=new ResizeObserver(()=>o.ask());a.observe(this.plots),this.stops.push(()=>a.disconnect(),o.stop,n.subscribe(()=>this.move()),...t.map(l=>l.onChange(()=>o.ask())))}pair;clock;element;plots=_("div",{class:"s-curves"});table=_("div",{class:"s-table",tabindex:0,role:"group","aria-label":"Differences"});stops=[];cursor=null;x=()=>0;destroy(){for(let t of this.stops)t()}draw(){let{clock:t,pair:e}=this,n=this.plots.clientWidth;if(!n)return;let s=Math.max(1,n-Qs-qp);this.x=c=>Qs+c/Math.max(t.duration,.001)*s;let r={force:20,performance:20+qu.force+PR},o=r.performance+qu.performance+Yy;this.cursor=ot("line",{y1:0,y2:o-Yy,stroke:"var(--ink)","stroke-width":1.5});let{times:a}=zh(0,t.duration,Math.max(2,s/90)),l=ot("svg",{width:n,height:o,role:"img","aria-label":"Force and performance of both recordings over time",click:({offsetX:c})=>t.seek((c-Qs)/s*t.duration)},...this.drawForce(r.force,n,Math.round(s)),...this.drawPerformance(r.performance,n),...a.map(c=>Yp(this.x(c),o-3,oe(c,0),"middle")),this.cursor);this.plots.replaceChildren(l),this.move(),this.table.replaceChildren(kR(DR(...e)))}move(){let t=this.x(this.clock.time).toFixed(1);this.cursor?.setAttribute("x1",t),this.cursor?.setAttribute("x2",t)}drawForce(t,e,n){let{clock:s,pair:r}=this,o=r.map(d=>NR(d,({normal:f})=>f,s.duration,n)),a=o.flat().filter(d=>d!==null),[l,c]=[Math.min(0,...a.map(([d])=>d)),Math.max(5,...a.map(([,d])=>d))],h=d=>t+qu.force*(1-(d-l)/(c-l)),u=o.map((d,f)=>{let p="";return d.forEach((x,m)=>{x&&(p+=`${p&&d[m-1]?"L":"M"}${Qs+m} ${h(x[0]).toFixed(1)}V${h(x[1]).toFixed(1)}`)}),ot("path",{d:p,fill:"none",stroke:Ky(f),...jy(f),"data-curve":`force-${mo[f]}`})});return[...Jy("Force [N]",t,e,h,[0,c/2,c].map(Math.round),String),...u]}drawPerformance(t,e){let n=a=>t+qu.performance*(1-a),s=this.pair.flatMap((a,l)=>a.rounds.flatMap(c=>this.drawRound(c,l,n))),o=[...new Set(this.pair.map(({head:a})=>a?.task?.target).filter(a=>a!==void 0))].map(a=>ot("line",{x1:Qs,x2:e-qp,y1:n(a),y2:n(a),stroke:"var(--target)","stroke-dasharray":"6 4"}));return[...Jy("Performance [%]",t,e,n,[0,.5,1],a=>String(100*a)),...o,...s]}drawRound({plan:t,start:e,end:n,length:s,interpreted:r,truth:o},a,l){let c=Ky(a),h=[];if(t.growth.length){let d=t.growth.map(([f,p])=>`${this.x(e+Math.min(f,s)).toFixed(1)} ${l(p).toFixed(1)}`);h.push(ot("path",{d:`M${d.join("L")}H${this.x(n).toFixed(1)}`,fill:"none",stroke:c,...jy(a),"data-curve":`predicted-${mo[a]}`}))}let u=this.x(n)-4-9*(1-a);if(r){let{mean:d,low:f,high:p}=r.estimate;h.push(ot("rect",{x:u-3,y:l(p),width:6,height:Math.max(1,l(f)-l(p)),fill:c,"fill-opacity":.3,stroke:c},ot("title",{},`${mo[a]}: estimated ${Xi(r.estimate)}`)),ot("circle",{cx:u,cy:l(d),r:3,fill:c}))}if(typeof o?.performance=="number"){let d=l(o.performance);h.push(ot("path",{d:`M${u-4} ${d-4}l8 8m0 -8l-8 8`,stroke:c,"stroke-width":2,fill:"none"},ot("title",{},`${mo[a]}: true ${Ct(o.performance)}`)))}return h}};function Jy(i,t,e,n,s,r){return[Yp(0,t-8,i,"start"),...s.flatMap(o=>[ot("line",{x1:Qs,x2:e-qp,y1:n(o),y2:n(o),stroke:"var(--rule)","stroke-width":.6}),Yp(Qs-6,n(o)+4,r(o),"end")])]}function Zp(i){return _("i",{class:`s-letter s-letter-${i?"second":"first"}`},mo[i]??"")}var kR=i=>bo(["",...mo,"B \u2212 A"],i.map(({label:t,texts:e,by:n})=>_("tr",{"data-differs":String(n!==""&&n!==An)},_("th",{scope:"row"},t),...e.map(s=>_("td",{title:s},s)),_("td",{},n||"same"))));var Qy=({rounds:i})=>new A(...i[0]?.plan.surface.pose.slice(0,3)??[]);function tv(i){let t=!1,e=i.map(({camera:n,recording:s})=>{let r=()=>{if(!(t||!n)){t=!0;for(let o of i){if(!o.camera||o.camera===n)continue;let a=Qy(o.recording).sub(Qy(s)),{target:l,eye:c}=n.view;o.camera.followLinked({target:l.add(a),eye:c.add(a)},n.asked)}t=!1}};return n?.controls.addEventListener("change",r),()=>n?.controls.removeEventListener("change",r)});return()=>{for(let n of e)n()}}var En=class extends Error{constructor(e,n){super(e.message);this.fault=e;this.status=n}fault;status},OR="The studio does not respond. If it has ended, start it again: wisch studio.";async function ju(i,t){let e;try{e=await fetch(i,{...t,cache:"no-store"})}catch{throw new En({message:OR},0)}if(e.ok)return e;throw new En(await FR(e),e.status)}async function FR(i){try{let t=await i.json();if(t.error)return t.error}catch{}return{message:`The studio refused the request with HTTP status ${i.status}.`}}var Ku=async(i,t,e)=>await(await ju(i,{method:"POST",headers:{"content-type":"application/json"},body:JSON.stringify(t),signal:e??null})).json(),ev=async i=>await(await ju(`api/overview?find=${encodeURIComponent(i)}`)).json(),nv=async()=>await(await ju("api/vocabulary")).json();async function iv(i,t){let e=await ju(`api/episodes/${encodeURIComponent(i)}/recording`);try{let n=new TextDecoder,s=e.body.getReader(),r="";for(let o=await s.read();!o.done;o=await s.read()){let a=n.decode(o.value,{stream:!0}),l=a.lastIndexOf(`
`);if(l>=0){for(let c of(r+a.slice(0,l)).split(`
`))t(c);r=""}r+=a.slice(l+1)}t(r+n.decode())}catch{throw new En({message:"The recording of this episode is damaged: it cannot be decompressed. To list damaged files, run: wisch memory verify."},0)}}var sv=async(i,t,e)=>{let n={task:i,...t===null?{}:{seed:t},...e?{strategy:e}:{}};return(await Ku("api/runs",n)).run},rv=i=>Ku(`api/runs/${encodeURIComponent(i)}/stop`,{}),ov=i=>Ku(`api/runs/${encodeURIComponent(i)}/clear`,{});async function av(i,t){let e=await Ku("api/ask",{query:i},t);if("error"in e)throw new En(e.error,200);return e}function jp(i,t){let e=new EventSource("api/overview/events");e.addEventListener("changed",i);let n=!1;e.addEventListener("open",()=>{t(!0),n&&i(),n=!1}),e.addEventListener("error",()=>{n=!0,t(!1),e.readyState===EventSource.CLOSED&&setTimeout(()=>jp(i,t),2e3)})}var UR=300,go=class{constructor(t){this.actions=t}actions;element=_("section",{class:"s-stage","aria-label":"Recording"});panes=[];clock=null;stops=[];get shown(){return this.panes}get time(){return this.panes[0]?.view.clock.time??0}say(t,e,...n){this.clear(),this.element.append(_("div",{class:`s-said s-${t}`,role:t==="fault"?"alert":"status"},_("p",{},e),...n))}show(t,e){this.clear();let n=t.length>1;this.element.classList.toggle("s-two",n);let s=n?new oo:void 0;this.clock=s??null,this.panes=t.map((a,l)=>this.makePane(a,s,l)),s&&this.compare(s);let r=this.panes[0].view.clock;e!==null&&r.seek(e);let o;this.stops.push(r.subscribe(()=>{clearTimeout(o),!(r.playing||r.following)&&(o=setTimeout(()=>this.actions.rests(r.time),UR))}),()=>clearTimeout(o))}compare(t){let[e,n]=this.panes;if(!e||!n)return;let s=new Zu([e.recording,n.recording],[e.id,n.id],t);this.element.append(s.element),this.stops.push(()=>s.destroy(),tv(this.panes.map(({view:{camera:r},recording:o})=>({camera:r,recording:o}))))}makePane(t,e,n){let{recording:s}=t,r=new Kp(t,!e,this.actions,h=>a.seek(h));e&&r.element.prepend(Zp(n));let o=_("div",{class:"s-view"});this.element.append(_("div",{class:"s-pane"},r.element,r.story,o));let a=sl(o,s,e?{compact:!0,clock:e}:{}),l=0,c=s.onChange(h=>{h?.piece==="samples"||l||(l=requestAnimationFrame(()=>{l=0,r.show()}))});return{...t,view:a,head:r,stop:c}}closeStories(){for(let{head:t}of this.panes)t.toggle(!1)}focus(){let t=this.panes[0]?.view.element;t&&(t.tabIndex=-1,t.focus({preventScroll:!0}))}onConnectionChanged(){for(let{head:t}of this.panes)t.show()}clear(){for(let t of this.stops)t();this.stops=[];for(let{view:t,head:e,stop:n}of this.panes)n(),e.destroy(),t.destroy();this.clock?.destroy(),this.clock=null,this.panes=[],this.element.classList.remove("s-two"),this.element.replaceChildren()}},BR={connecting:"connecting \u2026",live:"live",reconnecting:"connection lost, reconnecting \u2026",ended:"",lost:"the run ended unexpectedly",gone:"the run no longer exists"},Kp=class{constructor(t,e,n,s){this.source=t;this.whole=e;this.actions=n;let{recording:r,id:o}=t;this.wasLive=t.live!==null,this.summary=new ho(r,s),this.story=_("div",{class:"s-story",hidden:!0},this.summary.element),this.stopButton=_("button",{class:"w-button s-stop",type:"button",hidden:!0,click:()=>{this.stopIt(o)}},"Stop"),this.storyButton=_("button",{class:"w-button",type:"button","aria-pressed":"false",click:()=>this.toggle(this.story.hidden)},"Summary"),this.element=_("header",{class:"s-head"},this.title,this.result,this.connection,this.kept,_("span",{class:"s-actions"},this.stopButton,this.storyButton,e&&n.compare&&_("button",{class:"w-button",type:"button",click:()=>n.compare?.()},"Compare"))),this.show()}source;whole;actions;element;story;title=_("h1",{});result=_("span",{class:"s-result"});connection=_("span",{class:"s-connection",role:"status"});kept=_("span",{class:"s-kept w-quiet"});stopButton;storyButton;summary;wasLive;toggle(t){this.story.hidden=!t,this.storyButton.setAttribute("aria-pressed",String(t))}async stopIt(t){this.stopButton.disabled=!0,zt(this.stopButton,"Stopping \u2026");try{await rv(t)}catch(e){this.stopButton.disabled=!1,zt(this.stopButton,"Stop"),zt(this.connection,String(e.message))}}show(){let{recording:t,live:e,id:n}=this.source;zt(this.title,t.head?.title??n);let s=t.rounds.findLast(h=>h.interpreted)?.interpreted,{state:r,text:o}=co(t),a=[];if(s){let{mean:h,low:u,high:d}=s.estimate;a.push(_("b",{title:"estimated performance, 90 % interval"},Ct(h),_("small",{},` ${Ct(u)} \u2013 ${Ct(d)}`)))}(t.ended||r==="planned"||r==="logged")&&a.push(_("span",{class:"s-badge","data-state":r},o)),this.result.replaceChildren(...a);let l=e?.connection??"ended";this.connection.dataset.state=l,zt(this.connection,[BR[l],e?.message??""].filter(h=>h).join(": ")),this.stopButton.hidden=!e||l==="ended"||l==="lost"||l==="gone";let c=e?.episode??n;this.title.title=`${this.title.textContent} (${n})`,e&&l==="ended"&&this.kept.replaceChildren(this.actions.isKept(c)?_("a",{href:ws({kind:"episode",ids:[c],time:null,query:null}),title:c},"kept as an episode"):"not kept as an episode"),this.wasLive&&t.ended&&(this.wasLive=!1,this.whole&&this.toggle(!0))}destroy(){this.summary.destroy()}};async function zR(i){let t=Uint8Array.from(atob(i),n=>n.charCodeAt(0)),e=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return hi.parse(await new Response(e).text())}var Jp=class{constructor(t,e,n,s,r){this.answers=n;this.packed=s;let a=lu(n,{show:(c,h,u)=>{this.show(h,u)},clear:()=>{for(let{view:c}of this.stage.shown)c.clearShown()}});t.classList.add("s-studio"),t.append(_("aside",{class:"s-side s-asked"},_("header",{class:"s-top"},_("h2",{class:"s-name"},"Answers of the memory"),r),_("section",{class:"s-ask"},_("pre",{class:"s-printed"},e),_("div",{class:"s-answers"},...a))),this.stage.element),Object.assign(window,{wisch:{stage:this.stage}});let l=[..._s(n,null),...s.keys()].find(c=>s.has(c));l||qa(n)?this.show(null,l??null):this.stage.say("note","The answers name no episode that the page could show.")}answers;packed;stage=new go({rests:()=>{},compare:null,isKept:()=>!0});recordings=new Map;asked=0;async show(t,e){let n=++this.asked,s=_s(this.answers,t),r=this.stage.shown.find(({id:l})=>e?l===e:s.includes(l)),o=e??r?.id??s.find(l=>this.packed.has(l))??s[0];if(!o)return;if(!r){let l=this.packed.get(o);if(l===void 0){this.stage.say("note",`This page holds no recording of episode ${o}.`);return}this.stage.say("wait","Loading \u2026");let c=this.recordings.get(o)??zR(l);this.recordings.set(o,c);try{let h=await c;if(n!==this.asked)return;this.stage.show([{id:o,recording:h,live:null}],null)}catch(h){n===this.asked&&this.stage.say("fault",`The recording of episode ${o} cannot be decompressed: ${String(h)}`);return}}let a=this.stage.shown.find(l=>l.id===o);a&&au(a.view,ou(this.answers,t,o,a.recording))}};function lv(i,t){let e=s=>document.getElementById(s)?.textContent??"",n=new Map([...document.querySelectorAll("script[data-episode]")].map(s=>[s.dataset.episode,s.textContent??""]));new Jp(i,e("query"),JSON.parse(e("answers")),n,t)}var GR=12,VR=/(?:([a-z]+):)?('?)([A-Za-z_][A-Za-z0-9_]*)$/;function HR(i){let t=[],e=new Set;for(let{name:s,arity:r,meaning:o}of i.predicates){let a=/^([^:]*?\)|[^:]*?): /.exec(o)?.[1]??"",l=a.startsWith(`${s}(`)?a:r?`${s}(`:s;e.has(l)||(e.add(l),t.push({name:`${s}/${r}`,kind:"predicate",meaning:o,text:l}))}let n=s=>({name:r,label:o,comment:a})=>({name:r,kind:s,meaning:a||o,text:WR(r)});t.push(...i.classes.map(n("class")),...i.properties.map(n("property")),...i.individuals.map(n("individual")));for(let s of i.builtins)t.push({name:s,kind:"Prolog",meaning:"predicate of standard Prolog",text:s.replace(/\/\d+$/,/\/0$/.test(s)?"":"(")});return t}function WR(i){let[t,e]=i.split(":");return/^[a-z][A-Za-z0-9_]*$/.test(e)?i:`${t}:'${e}'`}function $R(i,t,e){let n=VR.exec(t.slice(0,e));if(!n||/^[A-Z_]/.test(n[0])&&!n[1]&&!n[2]&&n[0].length<2)return null;let[s,r,,o]=n,a=o.toLowerCase(),l=i.flatMap(h=>{let[u,d]=h.name.includes(":")?h.name.split(":"):["",h.name];if(r&&u!==r)return[];let f=d.toLowerCase().indexOf(a);return f<0?[]:[{proposal:h,place:f?1:0,length:d.length}]});l.sort((h,u)=>h.place-u.place||cv(h.proposal)-cv(u.proposal)||h.length-u.length);let c=l.slice(0,GR).map(({proposal:h})=>h);return c.length?{from:e-s.length,found:c}:null}var cv=({kind:i})=>["predicate","class","property","individual","Prolog"].indexOf(i),Ju=class{constructor(t){this.field=t;t.setAttribute("role","combobox"),t.setAttribute("aria-autocomplete","list"),t.setAttribute("aria-controls","s-proposals"),t.setAttribute("aria-expanded","false"),t.addEventListener("input",()=>this.updateProposals()),t.addEventListener("blur",()=>this.close()),t.addEventListener("keydown",e=>this.onKey(e))}field;list=_("ul",{class:"s-proposals",id:"s-proposals",role:"listbox","aria-label":"Completions",hidden:!0});all=[];now=null;chosen=0;setVocabulary(t){this.all=HR(t)}get isOpen(){return this.now!==null}close(){this.now=null,this.list.hidden=!0,this.field.setAttribute("aria-expanded","false"),this.field.removeAttribute("aria-activedescendant")}updateProposals(){let{value:t,selectionStart:e,selectionEnd:n}=this.field,s=/^[A-Za-z0-9_]/.test(t.slice(e));if(this.now=e===n&&!s?$R(this.all,t,e):null,!this.now)return this.close();this.chosen=0,this.draw()}draw(){let t=this.now.found.map(({name:e,kind:n,meaning:s},r)=>_("li",{id:`s-proposal-${r}`,role:"option","aria-selected":String(r===this.chosen),pointerdown:o=>{o.preventDefault(),this.chosen=r,this.accept()}},_("b",{},e),_("i",{},n),_("span",{},s)));this.list.replaceChildren(...t),this.list.hidden=!1,this.field.setAttribute("aria-expanded","true"),this.field.setAttribute("aria-activedescendant",`s-proposal-${this.chosen}`),t[this.chosen]?.scrollIntoView({block:"nearest"})}onKey(t){if(!this.now)return;let e=this.now.found.length;if(t.key==="ArrowDown")this.chosen=(this.chosen+1)%e;else if(t.key==="ArrowUp")this.chosen=(this.chosen+e-1)%e;else return t.key==="Tab"?this.accept(t):t.key==="Escape"?(t.preventDefault(),t.stopPropagation(),this.close()):void 0;t.preventDefault(),this.draw()}accept(t){t?.preventDefault();let{from:e,found:n}=this.now,{text:s}=n[this.chosen],{value:r,selectionStart:o}=this.field;this.field.setRangeText(s,e,o,"end");let a=this.field.selectionStart,l=r.slice(o);s.endsWith("(")&&l.startsWith("(")&&this.field.setRangeText("",a-1,a,"end"),this.close()}};var Qu=class{constructor(t){this.actions=t;this.button=_("button",{class:"w-button s-primary",type:"button",click:()=>this.asking?this.asking.abort():void this.ask()},"Ask"),this.element=_("section",{class:"s-ask",hidden:!0},_("div",{class:"s-field"},this.field,this.completer.list),_("div",{class:"s-row"},this.button,_("span",{class:"w-quiet"},"Enter: ask; Shift + Enter: new line; Tab: complete")),this.fault,this.examples,this.result),this.field.addEventListener("input",()=>{this.fault.hidden=!0}),this.loadVocabulary()}actions;element;field=_("textarea",{class:"s-query",rows:3,spellcheck:"false",autocomplete:"off","aria-label":"Query in Prolog",placeholder:"low_performance_round(Round, P)",keydown:t=>{t.key!=="Enter"||t.shiftKey||t.isComposing||(t.preventDefault(),this.ask())}});completer=new Ju(this.field);fault=_("div",{class:"w-complaint s-fault",role:"alert",hidden:!0});chips=_("div",{class:"s-chips"});examples=_("details",{class:"s-examples",open:!0},_("summary",{},_("h2",{},"Example questions")),this.chips);result=_("div",{class:"s-answers","aria-live":"polite"});button;asking=null;async loadVocabulary(){try{let t=await nv();this.completer.setVocabulary(t),this.chips.replaceChildren(...t.examples.map(({title:e,query:n},s)=>_("button",{class:"s-chip",type:"button",title:n,"data-example":s,click:()=>{this.field.value=n,this.ask()}},e)))}catch(t){this.complain({message:t.message})}}propose(t){this.asking?.abort(),this.asking=null,zt(this.button,"Ask"),this.completer.close(),this.field.value=t,this.fault.hidden=!0,this.examples.open=!1,this.actions.clear(),this.result.replaceChildren(_("p",{class:"s-remark"},"This query comes from the page's address. Press Ask to run it."))}async ask(){let t=this.field.value.trim();if(!t||this.asking)return;this.completer.close(),this.fault.hidden=!0;let e=new AbortController;this.asking=e,this.examples.open=!1,zt(this.button,"Cancel"),this.result.replaceChildren(_("p",{class:"w-quiet"},"Asking \u2026")),this.actions.asked(t);try{let n=await av(t,e.signal);this.result.replaceChildren(...lu(n,this.actions)),qa(n)?this.actions.show(n,null,null):this.actions.clear()}catch(n){if(this.asking!==e)return;this.result.replaceChildren(),e.signal.aborted||this.complain(n instanceof En?n.fault:{message:String(n)})}finally{this.asking===e&&(this.asking=null,zt(this.button,"Ask"))}}complain({message:t,offset:e,length:n,line:s,column:r}){let o=this.field.value.trim(),a=[_("p",{},t)];if(e!==void 0&&n!==void 0){let l=e+n;a.push(_("pre",{},o.slice(0,e),_("mark",{},o.slice(e,l)||"\u2038"),o.slice(l))),o.includes(`
`)&&a.push(_("p",{class:"w-quiet"},`line ${s}, column ${r}`)),this.field.value=o,document.activeElement===this.field&&this.field.setSelectionRange(e,l)}this.fault.replaceChildren(...a),this.fault.hidden=!1}};var XR=200,td=class{constructor(t){this.actions=t;let e;this.search=_("input",{class:"s-search",type:"search",placeholder:"Search episodes","aria-label":"Search episodes",autocomplete:"off",input:()=>{clearTimeout(e),e=setTimeout(()=>t.find(this.words),XR)}}),this.element=_("section",{class:"s-runs"},_("button",{class:"w-button s-primary",type:"button",click:()=>t.start()},"Start a task"),this.search,this.note,this.list,this.where)}actions;element;list=_("div",{class:"s-list"});search;where=_("p",{class:"s-where w-quiet"});note=_("div",{class:"s-picking",hidden:!0,role:"status"});overview=null;current=[];picking=null;drawn="";get words(){return this.search.value.trim()}show(t){this.overview=t,this.draw()}mark(t){this.current=t,this.draw()}compareWith(t){this.picking=t,this.note.hidden=!t,this.note.replaceChildren(...t?[_("p",{},"Choose a run or episode to compare with."),_("button",{class:"w-button",type:"button",click:()=>this.compareWith(null)},"Cancel")]:[])}draw(){if(!this.overview)return;let{list:t,runs:e,memory:n}=this.overview,s=JSON.stringify([t,e,this.current]);if(s===this.drawn)return;this.drawn=s;let r=document.activeElement?.dataset.key,o=[],a=e.filter(({state:l})=>l!=="ended");a.length&&o.push(_("h2",{},"Now"),_("ul",{},...a.map(l=>this.makeRun(l))));for(let[l,c]of ZR(t.episodes))o.push(_("h2",{},l),_("ul",{},...c.map(h=>this.makeEpisode(h))));!t.episodes.length&&(this.words||!a.length)&&o.push(_("p",{class:"w-quiet"},this.words?"No matching episodes.":"There are no episodes yet. Start a task.")),t.total>t.episodes.length&&o.push(_("p",{class:"w-quiet"},`The list shows the newest ${t.episodes.length} of ${t.total} episodes. Use the search for older ones.`)),t.broken.length&&o.push(_("details",{class:"s-broken"},_("summary",{},`${t.broken.length} unreadable ${t.broken.length===1?"episode":"episodes"}`),...t.broken.map(l=>_("p",{},l)))),this.list.replaceChildren(...o),zt(this.where,`Memory: ${n}`),r&&this.list.querySelector(`[data-key="${CSS.escape(r)}"]`)?.focus()}makeLink(t,e,...n){let s=this.current.includes(e);return _("a",{href:ws({kind:t,ids:[e],time:null,query:null}),"data-key":e,"aria-current":s?"true":null,click:r=>{!this.picking||r.ctrlKey||r.metaKey||r.shiftKey||(r.preventDefault(),this.actions.pick(e))}},...n)}makeRun({id:t,task:e,begun:n,state:s,message:r}){let o=s==="lost",a=o?"ended unexpectedly":`running${n?` since ${YR(n)}`:""}`;return _("li",{},this.makeLink("run",t,_("span",{class:"s-title"},_("i",{class:`s-dot${o?" s-dot-lost":""}`,"aria-hidden":"true"}),e),_("span",{class:"s-what"},_("span",{},a)),o&&r?_("span",{class:"s-what s-bad"},r):null),o&&_("button",{class:"w-button s-clear",type:"button",title:"Remove from the list","aria-label":`Remove ${e} from the list`,click:()=>{ov(t).catch(()=>{})}},"\xD7"))}makeEpisode(t){let{performance:e,low:n,high:s,rounds:r,collisions:o}=t,a=[hv(new Date(1e3*t.begun)),`${r} ${r===1?"round":"rounds"}`,`${Gt(t.seconds,0)} s`];o&&a.push(`${o} ${o===1?"push":"pushes"}`),t.has_recording||a.push("no recording"),t.verdict&&!t.met&&a.push(t.verdict);let l=n!==null&&s!==null?`, 90\u202F% interval ${Ct(n)} to ${Ct(s)}`:"";return _("li",{},this.makeLink("episode",t.id,_("span",{class:"s-title"},_("span",{},t.title),e===null?null:_("b",{title:`estimated performance${l}`},Ct(e)),qR(t)),_("span",{class:"s-what"},a.join(" \xB7 "))))}};function qR({met:i,verdict:t,performance:e}){let n=Mp(i,t),s=n==="unmet"&&e===null?"none":n;return _("span",{class:"s-badge","data-state":s,title:t??""},{met:"met",unmet:"not met",unknown:"unknown",none:"\u2013"}[s])}var hv=i=>i.toLocaleTimeString([],{hour:"2-digit",minute:"2-digit"});function YR(i){let t=new Date(`${i.replace(" ","T").replace(/Z$/,"")}Z`);return Number.isNaN(t.getTime())?i:hv(t)}function ZR(i){let t=new Map,e=s=>s.toLocaleDateString([],{weekday:"short",year:"numeric",month:"short",day:"numeric"}),n=e(new Date);for(let s of i){let r=e(new Date(1e3*s.begun));r===n&&(r="Today"),t.set(r,[...t.get(r)??[],s])}return t}var jR=4,KR=1e3,xo=new Map;async function uv(i){let t=xo.get(i);xo.delete(i);let e=t??await JR(i);return dv(i,e),e}async function JR(i){let t=new hi;return await iv(i,e=>t.applyLine(e)),t.close(),t}function dv(i,t){xo.set(i,t);let[e]=xo.keys();xo.size>jR&&e!==void 0&&xo.delete(e)}var ed=class{constructor(t,e){this.id=t;this.changed=e;this.open()}id;changed;recording=new hi;connection="connecting";message="";lines=0;events=null;later;failures=0;open(){let t=new EventSource(`api/runs/${encodeURIComponent(this.id)}/stream?after=${this.lines}`);this.events=t,t.addEventListener("open",()=>{this.failures=0,this.set("live")}),t.addEventListener("message",({data:e,lastEventId:n})=>{let s=Number(n);s<=this.lines||(this.lines=s,this.recording.applyLine(e))}),t.addEventListener("end",({data:e})=>this.end(e)),t.addEventListener("error",()=>{if(this.set("reconnecting"),t.readyState===EventSource.CLOSED){if(this.failures++,this.failures>3){this.recording.close(),this.set("gone");return}this.later=setTimeout(()=>this.open(),KR*this.failures)}})}end(t){this.close();let e=JSON.parse(t);this.message=e.message,this.recording.close();let n=e.state==="ended";n&&this.recording.ended&&dv(this.episode,this.recording),this.set(n?"ended":"lost")}get episode(){return this.recording.ended?.episode??this.id}set(t){this.connection=t,this.changed()}close(){clearTimeout(this.later),this.events?.close(),this.events=null}};var QR=["best","adaptive","grid","rrt","kde"],nd=class{constructor(t){this.begun=t;let e=_("form",{class:"s-own",submit:n=>{n.preventDefault(),this.start(this.path.value.trim())}},_("label",{},"Your own task file",this.path),_("button",{class:"w-button",type:"submit"},"Start"));this.element=_("dialog",{class:"s-dialog","aria-labelledby":"s-start-title"},_("header",{},_("h1",{id:"s-start-title"},"Start a task"),_("button",{class:"w-button",type:"button","aria-label":"Close",click:()=>this.element.close()},"\xD7")),this.fault,this.list,e,_("div",{class:"s-options"},_("label",{},"Seed",this.seed),_("label",{},"Strategy",this.strategy))),this.list.append(_("li",{},"Loading \u2026")),this.element.addEventListener("click",n=>{n.target===this.element&&this.element.close()}),this.element.addEventListener("input",()=>{this.fault.hidden=!0})}begun;element;list=_("ul",{class:"s-scenarios"});seed=_("input",{type:"number",min:0,step:1,placeholder:"from the task","aria-label":"Seed"});strategy=_("select",{class:"w-select","aria-label":"Strategy"},_("option",{value:""},"from the task"),...QR.map(t=>_("option",{value:t},t)));path=_("input",{type:"text",placeholder:"/path/to/task.toml","aria-label":"Task file on this machine",autocomplete:"off",spellcheck:"false"});fault=_("p",{class:"w-complaint",role:"alert",hidden:!0});busy=!1;known="";open(){this.fault.hidden=!0,this.element.showModal()}setScenarios(t){let e=JSON.stringify(t);e!==this.known&&(this.known=e,this.list.replaceChildren(...t.map(({name:n,about:s})=>_("li",{},_("div",{},_("b",{},n),_("p",{},s)),_("button",{class:"w-button s-primary",type:"button","data-task":n,"aria-label":`Start ${n}`,click:()=>{this.start(n)}},"Start")))),t.length||this.list.append(_("li",{},"No shipped tasks were found.")))}async start(t){if(this.busy)return;let e=this.seed.value.trim();if(!t)return this.complain("The path is empty. Enter the path of a task file.");if(e&&!/^\d+$/.test(e))return this.complain("The seed must be a whole number, 0 or greater.");this.fault.hidden=!0,this.setBusy(!0);try{let n=await sv(t,e?Number(e):null,this.strategy.value||null);this.element.close(),this.begun(n)}catch(n){this.complain(n instanceof En?n.message:String(n))}finally{this.setBusy(!1)}}setBusy(t){this.busy=t,this.element.toggleAttribute("data-busy",t);for(let e of this.element.querySelectorAll("button"))e.disabled=t}complain(t){this.fault.hidden=!1,zt(this.fault,t),this.fault.scrollIntoView({block:"nearest"})}};var ol={kind:"home",ids:[],time:null,query:null},Qp=class{side;stage;ask;dialog;tabs;offline=_("p",{class:"s-offline",role:"status",hidden:!0},"The studio does not respond. If it has ended, start it again: wisch studio.");aside;known=null;place=ol;live=[];waits=!1;opened=0;constructor(t,e){this.side=new td({find:()=>{this.refresh()},start:()=>this.dialog.open(),pick:s=>this.compare(s)}),this.ask=new Qu({show:(s,r,o)=>{this.show(s,r,o)},clear:()=>{for(let{view:s}of this.stage.shown)s.clearShown()},asked:s=>this.keep({query:s})}),this.stage=new go({rests:s=>this.keep({time:s}),compare:()=>{this.open("runs"),this.side.compareWith(this.place.ids[0]??null)},isKept:s=>this.isKept(s)}),this.dialog=new nd(s=>{this.go({...ol,kind:"run",ids:[s]}).then(()=>this.stage.focus())});let n=(s,r,o)=>_("button",{class:"w-button",type:"button","aria-pressed":"false",title:o,click:()=>this.isNarrow&&this.aside.dataset.open===s?this.open(null):this.open(s)},r);this.tabs={runs:n("runs","Runs","Runs and episodes"),ask:n("ask","Ask","Ask the memory ( / )")},this.aside=_("aside",{class:"s-side"},_("header",{class:"s-top"},_("h2",{class:"s-name"},"wisch studio"),this.tabs.runs,this.tabs.ask,e),this.offline,this.side.element,this.ask.element),t.classList.add("s-studio"),t.append(this.aside,this.stage.element,this.dialog.element),this.open("runs")}async begin(){addEventListener("hashchange",()=>{this.route()}),document.addEventListener("keydown",e=>{let n=e.target;e.key!=="/"||e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|TEXTAREA|SELECT)$/.test(n.tagName)||(e.preventDefault(),this.open("ask"),this.ask.field.focus())}),jp(()=>{this.refresh()},e=>{this.offline.hidden=e}),Object.assign(window,{wisch:{studio:this,stage:this.stage}});let t=this.refresh();Xp(location.hash).kind!=="episode"&&await t,await this.route()}get isNarrow(){return matchMedia("(max-width: 760px)").matches}open(t){this.aside.dataset.open=t??"",this.side.element.hidden=t!=="runs",this.ask.element.hidden=t!=="ask";for(let e of["runs","ask"])this.tabs[e].setAttribute("aria-pressed",String(t===e))}async refresh(){try{this.known=await ev(this.side.words),this.side.show(this.known),this.dialog.setScenarios(this.known.scenarios),this.stage.onConnectionChanged(),this.waits&&this.route()}catch(t){this.known||this.stage.say("fault",t.message)}}isKept(t){return this.known?.list.episodes.some(e=>e.id===t)??!1}async go(t){history.pushState(null,"",ws(t)||location.pathname),await this.route()}keep(t){this.place={...this.place,...t},qy(this.place)}async route(){let t=Xp(location.hash),{query:e}=t;t.kind==="home"&&(t={...this.first(),query:e});let n=this.place;this.place=t,!Xy(n,t)||!this.stage.shown.length?await this.load(t):t.time!==null&&Math.abs(t.time-this.stage.time)>.06&&this.stage.shown[0].view.seek(t.time),e&&e!==n.query&&(this.open("ask"),this.ask.propose(e))}first(){let t=this.known?.runs.find(({state:n})=>n==="running");if(t)return{...ol,kind:"run",ids:[t.id]};let e=this.known?.list.episodes.find(({has_recording:n})=>n);return e?{...ol,kind:"episode",ids:[e.id]}:ol}async load(t){let e=++this.opened;for(let n of this.live)n.close();if(this.live=[],this.side.compareWith(null),this.side.mark(t.ids),this.isNarrow&&t.kind!=="home"&&this.open(null),this.waits=t.kind==="home"&&!this.known,!this.waits){if(t.kind==="home"){this.stage.say("note","This memory has no runs yet.",_("button",{class:"w-button s-primary",type:"button",click:()=>this.dialog.open()},"Start a task"));return}this.stage.say("wait","Loading \u2026");try{let n=[];for(let s of t.ids)n.push(await this.source(s,t.kind==="run"));if(e!==this.opened)return;this.stage.show(n,t.time),document.title=`${n.map(({id:s,recording:r})=>r.head?.title??s).join(" | ")} \u2013 wisch studio`}catch(n){if(e!==this.opened)return;let s=n instanceof En?n.message:`The recording cannot be shown: ${String(n)}`;this.stage.say("fault",s,_("p",{class:"w-quiet"},"Queries about this episode still work."))}}}async source(t,e){if(e&&!this.isRun(t)&&await this.refresh(),this.isRun(t))return this.liveSource(t);try{return{id:t,recording:await uv(t),live:null}}catch(n){if(!(n instanceof En)||n.status!==404)throw n;if(await this.refresh(),this.isRun(t))return this.liveSource(t);throw this.known&&!this.isKept(t)?new En({message:`There is no run or episode ${t}. A run that is stopped before its first motion is not kept.`},404):n}}isRun(t){return this.known?.runs.some(e=>e.id===t)??!1}liveSource(t){let e=new ed(t,()=>this.liveChanged(e));return this.live.push(e),{id:t,recording:e.recording,live:e}}liveChanged(t){this.stage.onConnectionChanged(),t.connection==="ended"&&this.refresh().then(()=>{this.place.kind!=="run"||this.place.ids[0]!==t.id||!this.isKept(t.episode)||(this.keep({kind:"episode",ids:[t.episode]}),this.side.mark(this.place.ids))})}compare(t){let e=this.place.ids[0];this.side.compareWith(null),!(!e||e===t)&&this.go({kind:"compare",ids:[e,t],time:this.stage.time,query:null})}async show(t,e,n){let s=_s(t,e),r=this.stage.shown.find(({id:l})=>n?l===n:s.includes(l)),o=n??r?.id??s[0];if(!o)return;if(r)this.isNarrow&&this.open(null);else{let l={kind:"episode",ids:[o],time:null,query:this.place.query};history.pushState(null,"",ws(l)),this.place=l,await this.load(l)}let a=this.stage.shown.find(l=>l.id===o);a&&(this.stage.closeStories(),au(a.view,ou(t,e,o,a.recording)))}};function fv(i,t){new Qp(i,t).begin()}function tm(){let i=_("button",{class:"w-button w-theme",type:"button",click:()=>k0(fs()==="dark"?"light":"dark")}),t=()=>zt(i,fs()==="dark"?"Light":"Dark");return ps(t),t(),i}var mv=i=>{let t=/^#t=(\d+(?:\.\d+)?)$/.exec(i);return t?Number(t[1]):null};function tC({clock:i}){let t;i.subscribe(()=>{clearTimeout(t),!(i.playing||i.following)&&(t=setTimeout(()=>{let e=`#t=${i.time.toFixed(1)}`;if(!(location.hash===e||!location.hash&&i.time===0))try{history.replaceState(null,"",e)}catch{}},300))}),addEventListener("hashchange",()=>{let e=mv(location.hash);e!==null&&Math.abs(e-i.time)>.06&&i.seek(e)})}function eC(i){let t=hi.parse(document.getElementById("recording")?.textContent??"");i.classList.add("w-report");let e=new ho(t,s=>{n.seek(s),n.element.scrollIntoView({block:"start"})},tm());i.append(e.element);let n=sl(i,t);n.seek(mv(location.hash)??0),tC(n),Object.assign(window,{wisch:{recording:t,view:n,Recording:hi,mountView:sl}})}O0();var yo=document.getElementById("app"),{page:pv}=document.documentElement.dataset;yo&&pv==="report"?eC(yo):yo&&pv==="answers"?lv(yo,tm()):yo&&fv(yo,tm());})();
